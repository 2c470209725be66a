#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "poinsot/core/invariants.h"
#include "poinsot/core/motion.h"
#include "poinsot/scene/scene.h"
#include "poinsot/session/tick.h"

namespace poinsot::session {

/** One body of a scene, moved from tick to tick. */
class MovingBody {
 public:
  /** Stands at t = 0. Throws what Motion's constructor throws. */
  explicit MovingBody(const scene::Body& body);

  const std::string& name() const { return name_; }
  Motion& motion() { return motion_; }
  const Motion& motion() const { return motion_; }

  /** Takes a motion that was moved ahead elsewhere. */
  void replaceMotion(Motion&& motion) { motion_ = std::move(motion); }

  /**
   * Moves to the tick's time. Throws std::runtime_error where the motion has no state there that doubles can hold.
   * Returns whether this tick continues the segment of the last.
   */
  bool move(const Tick& tick);

  /** Moves to t [s] without a tick, to take another body's place between two ticks. Throws what Motion::at throws. */
  void stand(double t) { state_ = motion_.at(t); }

  /** Of the last move. */
  const MotionState& state() const { return state_; }
  /** Relative, since the beginning of the segment. */
  double energyDrift() const { return energy_drift_; }
  double momentumDrift() const { return momentum_drift_; }
  /** See Motion::attitudeError [rad]. */
  double attitudeError() const { return motion_.attitudeError(state_); }

  /** What the scene asks of the attitude [rad]; NaN where it asks for nothing. */
  double accuracy() const { return accuracy_; }

 private:
  std::string name_;
  Motion motion_;
  double accuracy_;
  MotionState state_;
  std::optional<std::uint32_t> segment_;
  Invariants segment_start_;
  double energy_drift_ = 0;
  double momentum_drift_ = 0;
};

}  // namespace poinsot::session
