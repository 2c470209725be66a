#pragma once

#include <Eigen/LU>
#include <limits>

#include "poinsot/core/no_convergence.h"
#include "poinsot/core/work.h"
#include "steppers/rotate.h"

namespace poinsot::steppers {

/**
 * The Lie-group midpoint rule (see E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed., §IV.8):
 *   θ = hM⁻¹exp(−θ/2)Λ.
 * Second order, symmetric: a step forwards and one backwards cancel. Conserves L, not E, whose error stays bounded.
 *
 * Solved by Newton's method with the derivative that leaves out a factor 1 + O(θ); throws NoConvergence.
 */
class Midpoint {
 public:
  explicit Midpoint(const Eigen::Vector3d& moments) : inverse_(moments.cwiseInverse()) {}

  /** Of one step. */
  static constexpr Work work(int iterations) { return {iterations, iterations + 1}; }

  /** @return iterations. */
  int step(FreeRotationState& state, double h) const {
    const Eigen::Vector3d& p = state.momentum_principal;
    const Eigen::Vector3d p0(p[0], p[1], p[2]), scale = h * inverse_;
    Eigen::Vector3d theta = scale.cwiseProduct(p0);
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMostIterations; ++i) {
      const Eigen::Vector3d m = turnedBack(p0, 0.5 * theta);
      const Eigen::Vector3d change = solve(0.5 * scale, m, scale.cwiseProduct(m) - theta);
      theta += change;
      const double moved = change.squaredNorm(), size = theta.squaredNorm();
      // Converged, as far as rounding allows.
      if (moved <= 1e-32 * size || (moved <= 1e-28 * size && moved >= 0.25 * last)) {
        rotate(state, theta);
        return i + 1;
      }
      last = moved;
    }
    throw NoConvergence("midpoint");
  }

 private:
  static constexpr int kMostIterations = 60;

  /** (1 − diag(s) hat(m)) x = b */
  static Eigen::Vector3d solve(const Eigen::Vector3d& s, const Eigen::Vector3d& m, const Eigen::Vector3d& b) {
    Eigen::Matrix3d a;
    a << 1, s[0] * m[2], -s[0] * m[1], -s[1] * m[2], 1, s[1] * m[0], s[2] * m[1], -s[2] * m[0], 1;
    return a.inverse() * b;
  }

  Eigen::Vector3d inverse_;
};

}  // namespace poinsot::steppers
