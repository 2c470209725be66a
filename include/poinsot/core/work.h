#pragma once

#include <cstdint>

namespace poinsot {

/** Evaluations and exponentials that a stretch of steps used; not the time that they took. */
struct Work {
  std::int64_t evaluations = 0;   ///< of the right-hand side or a derivative of it; of the equation of an implicit step
  std::int64_t exponentials = 0;  ///< turns of SO(3): exp, or Cayley's map
  std::int64_t torques = 0;       ///< evaluations of the torque or a derivative of it; of a free body none

  /** Adds the work of a further stretch. */
  Work& operator+=(const Work& other) {
    evaluations += other.evaluations;
    exponentials += other.exponentials;
    torques += other.torques;
    return *this;
  }
  /** Returns the work of n such stretches. */
  friend Work operator*(std::int64_t n, const Work& work) {
    return {n * work.evaluations, n * work.exponentials, n * work.torques};
  }
};

}  // namespace poinsot
