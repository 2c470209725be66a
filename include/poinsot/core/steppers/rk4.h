#pragma once

#include "poinsot/core/rotation.h"
#include "poinsot/core/rotation_state.h"

namespace poinsot::steppers {

/**
 * The classical Runge–Kutta method (Kutta 1901) on q̇ = ½q(0,Ω), Λ̇ = Λ × M⁻¹Λ, the quaternion renormalised after each
 * step: what most people write first. Fourth order; conserves nothing exactly.
 */
class Rk4 {
 public:
  explicit Rk4(const Eigen::Vector3d& moments)
      : inverse_(moments.cwiseInverse()),
        euler_(inverse_.z() - inverse_.y(), inverse_.x() - inverse_.z(), inverse_.y() - inverse_.x()) {}

  void step(RotationState& state, double h) const {
    const Eigen::Vector4d q = state.attitude.coeffs();
    const Eigen::Vector3d& p = state.momentum_body;
    Eigen::Vector4d dq1, dq2, dq3, dq4;
    Eigen::Vector3d dp1, dp2, dp3, dp4;
    derivative(q, p, dq1, dp1);
    derivative(q + (0.5 * h) * dq1, p + (0.5 * h) * dp1, dq2, dp2);
    derivative(q + (0.5 * h) * dq2, p + (0.5 * h) * dp2, dq3, dp3);
    derivative(q + h * dq3, p + h * dp3, dq4, dp4);
    state.attitude.coeffs() = (q + (h / 6.0) * (dq1 + 2.0 * (dq2 + dq3) + dq4)).normalized();
    state.momentum_body = p + (h / 6.0) * (dp1 + 2.0 * (dp2 + dp3) + dp4);
  }

 private:
  /** Quaternion coefficients in Eigen's order x, y, z, w. */
  void derivative(const Eigen::Vector4d& q, const Eigen::Vector3d& p, Eigen::Vector4d& dq, Eigen::Vector3d& dp) const {
    const Eigen::Vector3d half = 0.5 * inverse_.cwiseProduct(p);
    dq << q[3] * half[0] + q[1] * half[2] - q[2] * half[1], q[3] * half[1] + q[2] * half[0] - q[0] * half[2],
        q[3] * half[2] + q[0] * half[1] - q[1] * half[0], -(q[0] * half[0] + q[1] * half[1] + q[2] * half[2]);
    dp << euler_[0] * p[1] * p[2], euler_[1] * p[2] * p[0], euler_[2] * p[0] * p[1];
  }

  Eigen::Vector3d inverse_;
  Eigen::Vector3d euler_;  ///< Λ̇ᵢ = euler_ᵢ Λⱼ Λₖ
};

}  // namespace poinsot::steppers
