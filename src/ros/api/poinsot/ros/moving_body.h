#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/BodyDescription.h"
#include "poinsot/BodyState.h"
#include "poinsot/core/motion.h"
#include "poinsot/ros/body_picture.h"
#include "poinsot/ros/names.h"
#include "poinsot/ros/simulation_clock.h"
#include "poinsot/scene/scene.h"
#include "poinsot/view/layout.h"
#include "poinsot/view/picture_scale.h"

namespace poinsot::node {

/** One body of the scene as messages: moved from tick to tick, it says what is to be sent. It sends nothing itself. */
class MovingBody {
 public:
  /**
   * @param markers false: there is no picture(), which saves memory where there are many bodies.
   * @param keep see BodyPicture.
   */
  MovingBody(const scene::Body& body, const std::string& frame_prefix, bool markers = true,
             const std::optional<PictureFrame>& keep = std::nullopt);

  const std::string& name() const { return name_; }
  const names::Frames& frames() const { return frames_; }
  Motion& motion() { return motion_; }
  const Motion& motion() const { return motion_; }
  BodyPicture& picture() { return *picture_; }
  const BodyPicture& picture() const { return *picture_; }

  /** Takes a motion that was moved ahead elsewhere. */
  void replaceMotion(Motion&& motion) { motion_ = std::move(motion); }

  /**
   * Moves to the tick's time. Throws std::runtime_error where the motion has no state there that doubles can hold.
   * @return whether this tick continues the segment of the last.
   */
  bool move(const Tick& tick);

  /** Is at t [s] without a tick, as what takes another body's place between two ticks. Throws what Motion::at throws.
   */
  void stand(double t) { state_ = motion_.at(t); }

  /** Of the last move. */
  const MotionState& state() const { return state_; }
  double energyDrift() const { return energy_drift_; }
  double momentumDrift() const { return momentum_drift_; }
  double attitudeError() const { return motion_.attitudeError(state_); }

  void appendTransforms(const ros::Time& stamp, std::vector<geometry_msgs::TransformStamped>& out) const;
  void appendStaticTransforms(const ros::Time& stamp, std::vector<geometry_msgs::TransformStamped>& out) const;

  /** @param cost CPU seconds per simulated second; NaN where it is not measured. */
  BodyState stateMessage(const Tick& tick, double cost) const;
  nav_msgs::Odometry odometryMessage(const Tick& tick) const;
  BodyDescription description() const;

 private:
  std::string name_;
  names::Frames frames_;
  Motion motion_;
  double accuracy_;  ///< asked for [rad], NaN where none was
  std::unique_ptr<BodyPicture> picture_;
  view::Layout layout_;
  view::PictureScale scale_;
  MotionState state_;
  std::optional<std::uint32_t> segment_;
  Invariants segment_start_;
  double energy_drift_ = 0;
  double momentum_drift_ = 0;
};

}  // namespace poinsot::node
