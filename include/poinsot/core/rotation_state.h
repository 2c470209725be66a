#pragma once

#include "poinsot/core/eigen_types.h"

namespace poinsot {

/**
 * What a method moves of a free body: attitude and angular momentum, both referred to its principal axes.
 *
 * Λ rather than Ω because every Lie-group method rotates Λ, which keeps |L| to roundoff; Λ in body rather than L in
 * world axes because there an attitude error would be amplified by the ratio of the moments.
 */
struct FreeRotationState {
  Quaternion attitude = Quaternion::Identity();                  ///< R: principal axes → world, unit
  Eigen::Vector3d momentum_principal = Eigen::Vector3d::Zero();  ///< Λ = MΩ [kg·m²/s], principal axes

  // What compensated summation has left over, below the last bits of the above; zero for methods without it.
  Vector4 attitude_rest = Vector4::Zero();                  ///< in the order of attitude.coeffs()
  Eigen::Vector3d momentum_rest = Eigen::Vector3d::Zero();  ///< of momentum_principal [kg·m²/s]

  // The L that free motion keeps, for methods that undo the drift of it by rounding (see steppers/restore_momentum.h).
  Eigen::Vector3d kept_momentum = Eigen::Vector3d::Zero();  ///< L in world axes
  double kept_inverse_square = 0;                           ///< 1/|L|², 0 at rest
  int steps_since_restored = 0;                             ///< since rounding of L was last undone
  /** 2E/|L|² at the start, for methods whose constants depend on E: in units of their own, 0 where not known. */
  double kept_inverse_inertia = 0;
  /** 2E/|L|² − 1/μᵢ at the start, for methods that keep E, in the same units; of use where the line above is not 0. */
  Eigen::Vector3d kept_energy_gaps = Eigen::Vector3d::Zero();

  /** L = RΛ as it is now becomes the one to keep. */
  void keepMomentum();
  /** Whoever changes L (an impulse) says so by this, with the L that there was to keep and the change of it. */
  void keepMomentum(const Eigen::Vector3d& momentum_world);

  /** Ω = M⁻¹Λ [rad/s], principal axes. */
  Eigen::Vector3d omegaPrincipal(const Eigen::Vector3d& moments) const {
    return momentum_principal.cwiseQuotient(moments);
  }
  /** L = RΛ [kg·m²/s], world axes. */
  Eigen::Vector3d momentumWorld() const;
};

/** What a method moves of any body. Apart from the above so that the steps of a free body copy no more than they need.
 */
struct RotationState : FreeRotationState {
  Eigen::Vector3d slug_omega = Eigen::Vector3d::Zero();  ///< σ of a slug inside [rad/s], principal axes
  Eigen::Vector3d slug_rest = Eigen::Vector3d::Zero();   ///< what compensated summation has left over of σ [rad/s]

  /**
   * The state at the start of a motion, whose L is the one to keep.
   * @param moments principal moments [kg·m²].
   * @param attitude R: principal axes → world, unit.
   * @param omega_principal Ω [rad/s], principal axes.
   */
  static RotationState fromOmega(const Eigen::Vector3d& moments, const Quaternion& attitude,
                                 const Eigen::Vector3d& omega_principal);
};

}  // namespace poinsot
