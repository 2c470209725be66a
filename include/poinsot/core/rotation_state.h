#pragma once

#include "poinsot/core/eigen_types.h"

namespace poinsot {

/**
 * The state of a free body that methods step: its attitude and angular momentum, in principal axes.
 *
 * It holds Λ and not Ω, because every Lie-group method rotates Λ, which keeps |L| to roundoff; and Λ in body axes and
 * not L in world axes, where an error of the attitude would be amplified by the ratio of the moments.
 */
struct FreeRotationState {
  Quaternion attitude = Quaternion::Identity();                  ///< R: principal axes → world, unit
  Eigen::Vector3d momentum_principal = Eigen::Vector3d::Zero();  ///< Λ = MΩ [kg·m²/s], principal axes

  // The parts of the above that compensated summation holds below their last bits; zero for methods without it.
  Vector4 attitude_rest = Vector4::Zero();                  ///< in the order of attitude.coeffs()
  Eigen::Vector3d momentum_rest = Eigen::Vector3d::Zero();  ///< of momentum_principal [kg·m²/s]

  // For methods that undo the drift by rounding of what free motion conserves (see steppers/restore_momentum.h).
  Eigen::Vector3d kept_momentum = Eigen::Vector3d::Zero();  ///< the conserved L, world axes
  double kept_inverse_square = 0;                           ///< 1/|L|², 0 at rest
  int steps_since_restored = 0;                             ///< since the drift of L was last undone
  /** 2E/|L|² at the start, in units of the method's own; 0 where not known. */
  double kept_inverse_inertia = 0;
  /** 2E/|L|² − 1/μᵢ at the start, in the same units; not set while kept_inverse_inertia is 0. */
  Eigen::Vector3d kept_energy_gaps = Eigen::Vector3d::Zero();

  /** Makes the present L = RΛ the conserved one. */
  void keepMomentum();
  /** Makes this L [kg·m²/s, world axes] the conserved one, after an impulse has changed it. */
  void keepMomentum(const Eigen::Vector3d& momentum_world);

  /** Returns Ω = M⁻¹Λ [rad/s], principal axes. */
  Eigen::Vector3d omegaPrincipal(const Eigen::Vector3d& moments) const {
    return momentum_principal.cwiseQuotient(moments);
  }
  /** Returns L = RΛ [kg·m²/s], world axes. */
  Eigen::Vector3d momentumWorld() const;
};

/** The state of any body that methods step. Apart from the above, so that steps of a free body copy less. */
struct RotationState : FreeRotationState {
  Eigen::Vector3d slug_omega = Eigen::Vector3d::Zero();  ///< σ of a slug inside [rad/s], principal axes
  Eigen::Vector3d slug_rest = Eigen::Vector3d::Zero();   ///< the part of σ below its last bits [rad/s]

  /**
   * Returns the state at the start of a motion, whose L is the conserved one.
   * @param moments principal moments [kg·m²].
   * @param attitude R: principal axes → world, unit.
   * @param omega_principal Ω [rad/s], principal axes.
   */
  static RotationState fromOmega(const Eigen::Vector3d& moments, const Quaternion& attitude,
                                 const Eigen::Vector3d& omega_principal);
};

}  // namespace poinsot
