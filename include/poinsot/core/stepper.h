#pragma once

#include <cstdint>

#include "poinsot/core/rotation_state.h"
#include "poinsot/core/work.h"

namespace poinsot {

/** A one-step method, bound to one body and to what acts on it. */
class Stepper {
 public:
  virtual ~Stepper() = default;

  /**
   * Takes `count` steps of one length, from t = first·step on. Allocates nothing; the one virtual call is a batch's,
   * not a step's. Throws NoConvergence where an implicit method finds no step; `state` is then as it was. Under torques
   * the state is not finite afterwards where it left the range of doubles.
   * @param state in principal axes.
   * @param first index of the first step; the steps of a free body do not depend on it.
   * @param step [s], of either sign.
   * @param count ≥ 0.
   * @return the evaluations that it took.
   */
  virtual Work advance(RotationState& state, std::int64_t first, double step, std::int64_t count) const = 0;

  /** One step of `length` [s], of either sign, from any `time` [s]; otherwise like advance(). */
  virtual Work advanceFrom(RotationState& state, double time, double length) const = 0;
};

}  // namespace poinsot
