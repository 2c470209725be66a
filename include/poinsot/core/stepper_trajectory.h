#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "poinsot/core/rotation_state.h"
#include "poinsot/core/stepper.h"
#include "poinsot/core/work.h"

namespace poinsot {

/**
 * The motion under a stepper, on the grid n·h from t = 0, n ≥ 0 (h of either sign).
 *
 * The state at n is that after n steps from the start, bit for bit, in whatever order states are asked for: going back
 * starts from a checkpoint. Checkpoints are thinned as the motion grows, so memory is bounded. Copies share nothing but
 * the stepper.
 */
class StepperTrajectory {
 public:
  /**
   * Begins at n = 0.
   * @param stepper the method, bound to the body.
   * @param start the state at t = 0.
   * @param step h [s], not zero, finite.
   */
  StepperTrajectory(std::shared_ptr<const Stepper> stepper, const RotationState& start, double step);

  /** Returns how many steps at(n) would take now. */
  std::int64_t stepsTo(std::int64_t n) const;

  /** Returns the state after n ≥ 0 steps. */
  const RotationState& at(std::int64_t n);

  /** Takes the steps that at(n) needs. Returns false soon after `cancel` becomes true; the steps taken are kept. */
  bool moveTo(std::int64_t n, const std::atomic<bool>& cancel);

  /** Returns the stepper. */
  const Stepper& stepper() const { return *stepper_; }

  /** Returns the work of all steps so far. */
  const Work& work() const { return work_; }

 private:
  struct Checkpoint {
    std::int64_t n;
    RotationState state;
  };

  const Checkpoint& nearestBefore(std::int64_t n) const;
  void advanceTo(std::int64_t n);
  void remember(bool known);
  std::int64_t fineSpacing() const;

  std::shared_ptr<const Stepper> stepper_;
  double step_;
  Work work_;
  Checkpoint cursor_;
  std::vector<Checkpoint> coarse_;  ///< every spacing_ steps, from n = 0 towards furthest_
  std::vector<Checkpoint> fine_;    ///< inside the one coarse interval that was last gone over again
  std::int64_t spacing_;
  std::int64_t furthest_ = 0;  ///< greatest n reached
};

}  // namespace poinsot
