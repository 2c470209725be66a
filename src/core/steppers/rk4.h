#pragma once

#include "compensated_sum.h"
#include "poinsot/core/rotation_state.h"
#include "poinsot/core/work.h"
#include "steppers/move_attitude.h"

namespace poinsot::steppers {

/**
 * The classical Runge–Kutta method (Kutta 1901) on q̇ = ½q(0,Ω), Λ̇ = Λ × Ω, Ω = M⁻¹Λ, the quaternion renormalised at
 * each step: the usual first choice. Fourth order; conserves nothing exactly.
 *
 * Two things keep roundoff below its truncation error for longer: the increments are summed with compensation, and the
 * right-hand side divides by the moments instead of multiplying by rounded inverses, which would be the moments of a
 * slightly different body.
 *
 * Beyond the limit of stability, |Ω|h = 2.8, Λ grows without bound until Λ and the attitude are infinite or NaN.
 * judgeStep() refuses such steps beforehand.
 */
class Rk4 {
 public:
  static constexpr Work kWork = {4, 0};  ///< of a step

  explicit Rk4(const Eigen::Vector3d& moments)
      : moments_(moments),
        differences_(moments.y() - moments.z(), moments.z() - moments.x(), moments.x() - moments.y()) {}

  void step(FreeRotationState& state, double h) const {
    Eigen::Vector4d q = state.attitude.coeffs();
    const Eigen::Vector3d p = state.momentum_principal;
    Eigen::Vector4d dq1, dq2, dq3, dq4;
    Eigen::Vector3d dp1, dp2, dp3, dp4;
    derivative(q, p, dq1, dp1);
    derivative(q + (0.5 * h) * dq1, p + (0.5 * h) * dp1, dq2, dp2);
    derivative(q + (0.5 * h) * dq2, p + (0.5 * h) * dp2, dq3, dp3);
    derivative(q + h * dq3, p + h * dp3, dq4, dp4);
    const Eigen::Vector4d increment = (h / 6.0) * (dq1 + 2.0 * (dq2 + dq3) + dq4);
    moveAttitude(q, state.attitude_rest, increment);
    state.attitude.coeffs() = q;
    addCompensated<Eigen::Vector3d>(state.momentum_principal, state.momentum_rest,
                                    (h / 6.0) * (dp1 + 2.0 * (dp2 + dp3) + dp4));
  }

 private:
  /** Quaternion coefficients in Eigen's order x, y, z, w. Inline: four calls would make a step a fifth longer. */
  [[gnu::always_inline]] void derivative(const Eigen::Vector4d& q, const Eigen::Vector3d& p, Eigen::Vector4d& dq,
                                         Eigen::Vector3d& dp) const {
    const Eigen::Vector3d omega = p.cwiseQuotient(moments_);
    const Eigen::Vector3d half = 0.5 * omega;
    dq << q[3] * half[0] + q[1] * half[2] - q[2] * half[1], q[3] * half[1] + q[2] * half[0] - q[0] * half[2],
        q[3] * half[2] + q[0] * half[1] - q[1] * half[0], -(q[0] * half[0] + q[1] * half[1] + q[2] * half[2]);
    dp << differences_[0] * (omega[1] * omega[2]), differences_[1] * (omega[2] * omega[0]),
        differences_[2] * (omega[0] * omega[1]);
  }

  Eigen::Vector3d moments_;
  Eigen::Vector3d differences_;  ///< Λ̇ᵢ = (μⱼ − μₖ) Ωⱼ Ωₖ
};

}  // namespace poinsot::steppers
