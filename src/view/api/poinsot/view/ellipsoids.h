#pragma once

#include <Eigen/Core>

namespace poinsot::view {

/** Returns the semi-axes of the energy ellipsoid ΩᵀMΩ = 2E: √(2E/μᵢ) [rad/s], in the order of `moments` [kg·m²]. */
Eigen::Vector3d energySemiAxes(const Eigen::Vector3d& moments, double kinetic_energy);

/** Returns the semi-axes of the momentum ellipsoid ΩᵀM²Ω = F: √F/μᵢ [rad/s]; F = |L|² [(kg·m²/s)²]. */
Eigen::Vector3d momentumSemiAxes(const Eigen::Vector3d& moments, double momentum_squared);

/** Returns the longest semi-axis of the two ellipsoids of a body that turns with Ω [rad/s]: |L|/μmin [rad/s]. */
double longestSemiAxis(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal);

}  // namespace poinsot::view
