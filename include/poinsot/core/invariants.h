#pragma once

#include <Eigen/Core>

#include "poinsot/core/rotation_state.h"

namespace poinsot {

/** The quantities that a free rigid body conserves. */
struct Invariants {
  double kinetic_energy = 0;                                 ///< E = ½ΩᵀMΩ [J]
  double momentum_squared = 0;                               ///< F = ΛᵀΛ = |L|² [(kg·m²/s)²]
  Eigen::Vector3d momentum_world = Eigen::Vector3d::Zero();  ///< L = RΛ [kg·m²/s], world axes
};

/**
 * Returns E, F and L of a state.
 * @param moments principal moments [kg·m²] of the axes that the state refers to.
 * @param state attitude and Λ in principal axes.
 */
Invariants invariantsOf(const Eigen::Vector3d& moments, const FreeRotationState& state);

/** Returns (E − E_ref)/E_ref; 0 when both vanish, infinite when only E_ref does. */
double energyDrift(const Invariants& now, const Invariants& reference);

/**
 * Returns |L − L_ref|/|L_ref| in world axes, so that a turn of L counts; 0 when both vanish, infinite when only L_ref
 * does.
 */
double momentumDrift(const Invariants& now, const Invariants& reference);

}  // namespace poinsot
