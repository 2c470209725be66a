#pragma once

#include <Eigen/Core>
#include <random>

namespace poinsot::view {

struct Body {
  Eigen::Vector3d moments, omega;
};

/** 2E and F = |L|². */
inline double energy2(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega) {
  return omega.dot(moments.cwiseProduct(omega));
}
inline double momentum2(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega) {
  return moments.cwiseProduct(omega).squaredNorm();
}

/** Bodies with axes in any order; `decades`: spread of the moments. Draws are the same in every run. */
class RandomBodies {
 public:
  explicit RandomBodies(double decades) : decades_(decades) {}

  Body draw() {
    Body b;
    for (int i = 0; i < 3; ++i) {
      b.moments[i] = std::pow(10.0, decades_ * unit_(random_));
      b.omega[i] = 2 * unit_(random_) - 1;
    }
    return b;
  }

 private:
  std::mt19937_64 random_{20};
  std::uniform_real_distribution<double> unit_{0, 1};
  double decades_;
};

}  // namespace poinsot::view
