#pragma once

#include <cstdint>

#include "poinsot/core/rotation_state.h"
#include "poinsot/core/work.h"

namespace poinsot {

/** A one-step method, bound to one body and the torques on it. */
class Stepper {
 public:
  virtual ~Stepper() = default;

  /**
   * Takes `count` steps of one length, from t = first·step on, in one virtual call and without allocating. Throws
   * NoConvergence where an implicit method finds no solution of a step; `state` is then unchanged. Under torques, a
   * state that leaves the range of doubles is not finite afterwards.
   * @param state in principal axes.
   * @param first index of the first step; the steps of a free body do not depend on it.
   * @param step [s], of either sign.
   * @param count ≥ 0.
   * @return the work that the steps took.
   */
  virtual Work advance(RotationState& state, std::int64_t first, double step, std::int64_t count) const = 0;

  /** Takes one step of `length` [s], of either sign, from any `time` [s]; otherwise like advance(). */
  virtual Work advanceFrom(RotationState& state, double time, double length) const = 0;
};

}  // namespace poinsot
