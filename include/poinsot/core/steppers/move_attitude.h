#pragma once

#include <Eigen/Core>
#include <cmath>

#include "poinsot/core/compensated_sum.h"

namespace poinsot::steppers {

/** q + increment, brought back to |q| = 1 along itself, which does not turn it. Summed with compensation. */
inline void moveAttitude(Eigen::Vector4d& q, Eigen::Vector4d& rest, const Eigen::Vector4d& increment) {
  const Eigen::Vector4d moved = q + increment;
  const double norm = moved.norm();
  if (std::abs(norm - 1) < 0.5) {
    addCompensated<Eigen::Vector4d>(q, rest, increment + (1.0 / norm - 1.0) * moved);
  } else {  // a step so long that the correction is no small one: as a sum it would lose what is left
    q = moved / moved.stableNorm();
    rest.setZero();
  }
}

}  // namespace poinsot::steppers
