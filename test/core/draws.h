#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace poinsot {

/** Random quantities, the same in every run. */
class Draws {
 public:
  double uniform(double low, double high) { return low + (high - low) * unit_(random_); }

  Eigen::Vector3d vector(double size = 1) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }

  Eigen::Vector3d direction() {
    Eigen::Vector3d v;
    do v = vector();
    while (v.norm() > 1 || v.norm() < 0.1);
    return v.normalized();
  }

  Eigen::Quaterniond attitude() {
    const Eigen::Vector4d c(normal_(random_), normal_(random_), normal_(random_), normal_(random_));
    return Eigen::Quaterniond(Eigen::Vector4d(c.normalized()));
  }

  /** Moments of a real body, in any order. */
  Eigen::Vector3d moments() {
    const Eigen::Vector3d spread(uniform(0.2, 1), uniform(0.2, 1), uniform(0.2, 1));
    return {spread[1] + spread[2], spread[0] + spread[2], spread[0] + spread[1]};
  }

 private:
  std::mt19937_64 random_{1758};
  std::uniform_real_distribution<double> unit_{0, 1};
  std::normal_distribution<double> normal_{0, 1};
};

}  // namespace poinsot
