#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

namespace poinsot::view {

/** Principal axes by rising moment: moment(0) ≤ moment(1) ≤ moment(2), scaled by a power of two to at most 1. */
class SortedAxes {
 public:
  explicit SortedAxes(const Eigen::Vector3d& moments) {
    std::stable_sort(index.begin(), index.end(), [&](int a, int b) { return moments[a] < moments[b]; });
    const int exponent = std::ilogb(moments.maxCoeff()) + 1;
    for (int i = 0; i < 3; ++i) moment[i] = std::ldexp(moments[index[i]], -exponent);
  }

  std::array<int, 3> index = {0, 1, 2};  ///< place in the caller's order
  std::array<double, 3> moment = {};
};

}  // namespace poinsot::view
