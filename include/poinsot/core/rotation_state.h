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

  static RotationState fromOmega(const Eigen::Vector3d& moments, const Eigen::Quaterniond& attitude,
                                 const Eigen::Vector3d& omega_body) {
    return {attitude, moments.cwiseProduct(omega_body)};
  }
  Eigen::Vector3d omegaBody(const Eigen::Vector3d& moments) const { return momentum_body.cwiseQuotient(moments); }
  Eigen::Vector3d momentumWorld() const { return attitude * momentum_body; }
};

}  // namespace poinsot
