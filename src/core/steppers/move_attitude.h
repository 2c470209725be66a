#pragma once

#include <cmath>

#include "compensated_sum.h"
#include "poinsot/core/eigen_types.h"

namespace poinsot::steppers {

/** Adds an increment to q and scales the sum to |q| = 1; summed with compensation. */
inline void moveAttitude(Eigen::Vector4d& q, Vector4& attitude_rest, const Eigen::Vector4d& increment) {
  const Eigen::Vector4d moved = q + increment;
  const double norm = moved.norm();
  if (std::abs(norm - 1) < 0.5) {
    Eigen::Vector4d rest = attitude_rest;
    addCompensated<Eigen::Vector4d>(q, rest, increment + (1.0 / norm - 1.0) * moved);
    attitude_rest = rest;
  } else {  // a step so long that the correction is large, and adding it would lose digits
    q = moved / moved.stableNorm();
    attitude_rest.setZero();
  }
}

}  // namespace poinsot::steppers
