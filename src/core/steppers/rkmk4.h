#pragma once

#include "poinsot/core/work.h"
#include "steppers/rotate.h"

namespace poinsot::steppers {

/**
 * Runge–Kutta–Munthe-Kaas of fourth order (H. Munthe-Kaas, Appl. Numer. Math. 29 (1999) 115–127): the classical
 * Runge–Kutta method for the rotation vector of the step,
 *   θ' = Ω + ½θ×Ω + (1/12)θ×(θ×Ω),  Ω = M⁻¹exp(−θ)Λ₀,  θ(0) = 0,
 * the inverse of dexp cut off where order four allows it. Conserves L, not E.
 */
class Rkmk4 {
 public:
  static constexpr Work kWork = {4, 4};  ///< of a step

  explicit Rkmk4(const Eigen::Vector3d& moments) : inverse_(moments.cwiseInverse()) {}

  void step(FreeRotationState& state, double h) const {
    const Eigen::Vector3d& p = state.momentum_principal;
    const Eigen::Vector3d p0(p[0], p[1], p[2]), scale = h * inverse_;
    const Eigen::Vector3d k1 = scale.cwiseProduct(p0);
    const Eigen::Vector3d k2 = rate(scale, p0, 0.5 * k1);
    const Eigen::Vector3d k3 = rate(scale, p0, 0.5 * k2);
    const Eigen::Vector3d k4 = rate(scale, p0, k3);
    rotate(state, (1.0 / 6) * (k1 + 2 * (k2 + k3) + k4));
  }

 private:
  [[gnu::always_inline]] static Eigen::Vector3d rate(const Eigen::Vector3d& scale, const Eigen::Vector3d& p0,
                                                     const Eigen::Vector3d& theta) {
    const Eigen::Vector3d w = scale.cwiseProduct(turnedBack(p0, theta)), once = theta.cross(w),
                          twice = theta.cross(once);
    // By components: Eigen's loop over them is not always inlined, which takes a twentieth longer.
    return {w[0] + 0.5 * once[0] + (1.0 / 12) * twice[0], w[1] + 0.5 * once[1] + (1.0 / 12) * twice[1],
            w[2] + 0.5 * once[2] + (1.0 / 12) * twice[2]};
  }

  Eigen::Vector3d inverse_;
};

}  // namespace poinsot::steppers
