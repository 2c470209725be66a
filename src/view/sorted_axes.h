#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "poinsot/core/inertia.h"

namespace poinsot::view {

/** Principal axes by rising moment: moment(0) ≤ moment(1) ≤ moment(2), scaled by a power of two to at most 1. */
class SortedAxes {
 public:
  explicit SortedAxes(const Eigen::Vector3d& moments) : index(ascendingAxes(moments)) {
    const int exponent = std::ilogb(moments.maxCoeff()) + 1;
    for (int i = 0; i < 3; ++i) moment[i] = std::ldexp(moments[index[i]], -exponent);
  }

  /** Returns whether no two moments are equal. */
  bool allDiffer() const { return moment[0] < moment[1] && moment[1] < moment[2]; }

  /** Returns the components of a vector in the order of rising moments. */
  Eigen::Vector3d sorted(const Eigen::Vector3d& v) const { return {v[index[0]], v[index[1]], v[index[2]]}; }

  /** Returns the components of a vector from the order of rising moments in the caller's order. */
  Eigen::Vector3d inCallersOrder(const Eigen::Vector3d& sorted) const {
    Eigen::Vector3d out;
    for (int i = 0; i < 3; ++i) out[index[i]] = sorted[i];
    return out;
  }

  std::array<int, 3> index;  ///< place in the caller's order
  std::array<double, 3> moment = {};
};

}  // namespace poinsot::view
