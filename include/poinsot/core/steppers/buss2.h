#pragma once

#include "poinsot/core/steppers/rotate.h"

namespace poinsot::steppers {

/**
 * Buss's augmented second-order method (S. R. Buss, "Accurate and efficient simulation of rigid-body rotations",
 * J. Comput. Phys. 164 (2000) 377–406): R ← exp(hω̃)R in world axes with
 *   ω̃ = ω + (h/2)α + (h²/12)(α × ω),   α = dω/dt = −M_w⁻¹(ω × L).
 *
 * Written here in body axes, where dω/dt has the components Ω̇ = M⁻¹(Λ × Ω). Conserves L, not E.
 */
class Buss2 {
 public:
  explicit Buss2(const Eigen::Vector3d& moments) : inverse_(moments.cwiseInverse()) {}

  void step(RotationState& state, double h) const {
    const Eigen::Vector3d omega = inverse_.cwiseProduct(state.momentum_body);
    const Eigen::Vector3d alpha = inverse_.cwiseProduct(state.momentum_body.cross(omega));
    rotate(state, h * (omega + (0.5 * h) * alpha + (h * h / 12.0) * alpha.cross(omega)));
  }

 private:
  Eigen::Vector3d inverse_;
};

}  // namespace poinsot::steppers
