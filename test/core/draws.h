#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace poinsot {

/** Random quantities, the same in every run and under every compiler: none is drawn among the arguments of a call. */
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
    const double w = normal_(random_), z = normal_(random_), y = normal_(random_), x = normal_(random_);
    return Eigen::Quaterniond(Eigen::Vector4d(Eigen::Vector4d(x, y, z, w).normalized()));
  }

  /** Moments of a real body, in any order. */
  Eigen::Vector3d moments() {
    const double z = uniform(0.2, 1), y = uniform(0.2, 1), x = uniform(0.2, 1);
    return {y + z, x + z, x + y};
  }

 private:
  std::mt19937_64 random_{1758};
  std::uniform_real_distribution<double> unit_{0, 1};
  std::normal_distribution<double> normal_{0, 1};
};

}  // namespace poinsot
