#pragma once

#include "poinsot/core/work.h"
#include "steppers/rotate.h"

namespace poinsot::steppers {

/**
 * Buss's augmented second-order method (S. R. Buss, "Accurate and efficient simulation of rigid-body rotations",
 * J. Comput. Phys. 164 (2000) 377–406): R ← exp(hω̃)R in world axes with
 *   ω̃ = ω + (h/2)α + (h²/12)(α × ω),   α = dω/dt = −M_w⁻¹(ω × L).
 *
 * Written here in body axes, where dω/dt has the components Ω̇ = M⁻¹(Λ × Ω), and for t = hΩ: with the ratios
 * r₁ = (μ₂ − μ₃)/μ₁, … h²Ω̇ = (r₁t₂t₃, r₂t₃t₁, r₃t₁t₂), so that
 *   θ₁ = t₁ + r₁t₂t₃/2 + (r₂t₃² − r₃t₂²)t₁/12, and so on round.
 * Only ratios of the moments and angles occur: no scale of either is too large or too small. Conserves L, not E.
 */
class Buss2 {
 public:
  static constexpr Work kWork = {2, 1};  ///< of a step

  explicit Buss2(const Eigen::Vector3d& moments)
      : inverse_(moments.cwiseInverse()),
        twelfths_(Eigen::Vector3d(moments[1] - moments[2], moments[2] - moments[0], moments[0] - moments[1])
                      .cwiseQuotient(12 * moments)) {}

  void step(FreeRotationState& state, double h) const {
    const Eigen::Vector3d& p = state.momentum_principal;
    const double t0 = (h * inverse_[0]) * p[0], t1 = (h * inverse_[1]) * p[1], t2 = (h * inverse_[2]) * p[2];
    const double r0 = twelfths_[0], r1 = twelfths_[1], r2 = twelfths_[2];
    const double s0 = t0 * t0, s1 = t1 * t1, s2 = t2 * t2;
    rotate(state, {t0 * (1 + (r1 * s2 - r2 * s1)) + (6 * r0) * (t1 * t2),
                   t1 * (1 + (r2 * s0 - r0 * s2)) + (6 * r1) * (t2 * t0),
                   t2 * (1 + (r0 * s1 - r1 * s0)) + (6 * r2) * (t0 * t1)});
  }

 private:
  Eigen::Vector3d inverse_;
  Eigen::Vector3d twelfths_;  ///< r/12
};

}  // namespace poinsot::steppers
