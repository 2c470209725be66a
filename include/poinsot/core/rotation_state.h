#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace poinsot {

/**
 * What a method moves: attitude and angular momentum, both referred to the principal axes of the body.
 *
 * Λ rather than Ω because every Lie-group method rotates Λ, which keeps |L| to roundoff; Λ in body rather than L in
 * world axes because there an attitude error would be amplified by the ratio of the moments.
 */
struct RotationState {
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< R: principal axes → world, unit
  Eigen::Vector3d momentum_body = Eigen::Vector3d::Zero();       ///< Λ = MΩ [kg·m²/s], principal axes

  // What compensated summation has left over, below the last bits of the above; zero for methods without it.
  Eigen::Vector4d attitude_rest = Eigen::Vector4d::Zero();  ///< in the order of attitude.coeffs()
  Eigen::Vector3d momentum_rest = Eigen::Vector3d::Zero();

  static RotationState fromOmega(const Eigen::Vector3d& moments, const Eigen::Quaterniond& attitude,
                                 const Eigen::Vector3d& omega_body) {
    RotationState state;
    state.attitude = attitude;
    state.momentum_body = moments.cwiseProduct(omega_body);
    return state;
  }
  Eigen::Vector3d omegaBody(const Eigen::Vector3d& moments) const { return momentum_body.cwiseQuotient(moments); }
  Eigen::Vector3d momentumWorld() const { return attitude * momentum_body; }
};

}  // namespace poinsot
