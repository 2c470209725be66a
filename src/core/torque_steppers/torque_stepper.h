#pragma once

#include <cstdint>
#include <utility>

#include "poinsot/core/stepper.h"
#include "poinsot/core/torques.h"

namespace poinsot::torque_steppers {

/** The base of all methods for bodies under torques: their steps end where a torque switches. */
class TorqueStepper : public Stepper {
 public:
  /** @param torques that act on the body; its moments are theirs. */
  explicit TorqueStepper(Torques torques) : torques_(std::move(torques)) {}

  Work advance(RotationState& state, std::int64_t first, double step, std::int64_t count) const final;

  /** Takes one step, or several that end where a torque switches in between. */
  Work advanceFrom(RotationState& state, double time, double length) const final;

 protected:
  /** Takes one step of h [s] from t on, in all of which `constant` acts. */
  virtual Work step(RotationState& state, double t, double h, const Torques::Constant& constant) const = 0;

  const Torques& torques() const { return torques_; }

 private:
  Torques torques_;
};

}  // namespace poinsot::torque_steppers
