#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "poinsot/core/rotation_state.h"
#include "poinsot/core/stepper.h"
#include "poinsot/core/torque_stepper.h"
#include "poinsot/core/work.h"

namespace poinsot {

/** How a free body goes from one point of a grid to later ones. */
struct FreeFlow {
  using State = RotationState;             ///< what it moves
  std::shared_ptr<const Stepper> stepper;  ///< the method, bound to the body

  /** `count` steps of `step` [s] from t = n·step on, for which a free body need not ask. */
  Work advance(State& state, std::int64_t, double step, std::int64_t count) const {
    return stepper->advance(state, step, count);
  }
  /** A step of `part` [s] from t on. */
  Work advancePart(State& state, double, double part) const { return stepper->advance(state, part, 1); }
};

/** The same under torques. */
struct TorquedFlow {
  using State = TorquedState;                    ///< what it moves
  std::shared_ptr<const TorqueStepper> stepper;  ///< the method, bound to the body and its torques

  /** `count` steps of `step` [s] from t = n·step on; where a step throws, `state` is as it was. */
  Work advance(State& state, std::int64_t n, double step, std::int64_t count) const {
    State moved = state;  // advance() may throw
    Work work;
    for (const std::int64_t end = n + count; n < end; ++n) {
      work += stepper->advance(moved, static_cast<double>(n) * step, step);
    }
    state = moved;
    return work;
  }
  /** A step of `part` [s] from t on. */
  Work advancePart(State& state, double t, double part) const { return stepper->advance(state, t, part); }
};

/**
 * The motion under a stepper, on the grid n·h from t = 0, n ≥ 0 (h of either sign).
 *
 * The state at n is what n steps from the start give, bit for bit, however one got there: going back starts from a
 * checkpoint. Checkpoints are thinned as the motion grows, so memory is bounded. Copies share nothing but the stepper.
 */
template <class Flow>
class GridTrajectory {
 public:
  using State = typename Flow::State;  ///< what it moves

  /**
   * Begins at n = 0.
   * @param flow a FreeFlow or TorquedFlow.
   * @param start the state at t = 0.
   * @param step h [s], not zero, finite.
   */
  GridTrajectory(Flow flow, const State& start, double step);

  /** How many steps at(n) would take now. */
  std::int64_t stepsTo(std::int64_t n) const;

  /** The state after n ≥ 0 steps. */
  const State& at(std::int64_t n);

  /** Like at(n), but gives up, returning false, soon after `cancel` becomes true; what was reached is kept. */
  bool moveTo(std::int64_t n, const std::atomic<bool>& cancel);

  /** What moves it. */
  const Flow& flow() const { return flow_; }

  /** What all steps so far took. */
  const Work& work() const { return work_; }

 private:
  struct Checkpoint {
    std::int64_t n;
    State state;
  };

  const Checkpoint& nearestBefore(std::int64_t n) const;
  void advanceTo(std::int64_t n);
  void remember(bool known);
  std::int64_t fineSpacing() const;

  Flow flow_;
  double step_;
  Work work_;
  Checkpoint cursor_;
  std::vector<Checkpoint> coarse_;  ///< every spacing_ steps, from n = 0 towards furthest_
  std::vector<Checkpoint> fine_;    ///< inside the one coarse interval that is being played backwards
  std::int64_t spacing_;
  std::int64_t furthest_ = 0;  ///< greatest n reached
};

/** Of a free body under a stepper. */
using StepperTrajectory = GridTrajectory<FreeFlow>;
/** Of a body under torques. */
using TorquedTrajectory = GridTrajectory<TorquedFlow>;

}  // namespace poinsot
