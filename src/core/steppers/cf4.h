#pragma once

#include "poinsot/core/work.h"
#include "steppers/rotate.h"

namespace poinsot::steppers {

/**
 * The commutator-free method of fourth order (E. Celledoni, A. Marthinsen, B. Owren, Future Gener. Comput. Syst. 19
 * (2003) 341–352): kᵢ = hΩ at stage i,
 *   Λ₂ = exp(−k₁/2)Λ, Λ₃ = exp(−k₂/2)Λ, Λ₄ = exp(−(k₃ − k₁/2))Λ₂,
 * and two turns of the body, first by (3k₁ + 2k₂ + 2k₃ − k₄)/12, then by (−k₁ + 2k₂ + 2k₃ + 3k₄)/12.
 * Conserves L, not E.
 */
class Cf4 {
 public:
  static constexpr Work kWork = {4, 5};  ///< of a step

  explicit Cf4(const Eigen::Vector3d& moments) : inverse_(moments.cwiseInverse()) {}

  void step(FreeRotationState& state, double h) const {
    const Eigen::Vector3d& p = state.momentum_principal;
    const Eigen::Vector3d p1(p[0], p[1], p[2]), scale = h * inverse_;
    const Eigen::Vector3d k1 = scale.cwiseProduct(p1), p2 = turnedBack(p1, 0.5 * k1);
    const Eigen::Vector3d k2 = scale.cwiseProduct(p2);
    const Eigen::Vector3d k3 = scale.cwiseProduct(turnedBack(p1, 0.5 * k2));
    const Eigen::Vector3d k4 = scale.cwiseProduct(turnedBack(p2, k3 - 0.5 * k1));
    rotate(state, (1.0 / 12) * (3 * k1 + 2 * (k2 + k3) - k4));
    rotate(state, (1.0 / 12) * (2 * (k2 + k3) + 3 * k4 - k1));
  }

 private:
  Eigen::Vector3d inverse_;
};

}  // namespace poinsot::steppers
