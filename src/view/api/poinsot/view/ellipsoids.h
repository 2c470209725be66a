#pragma once

#include <Eigen/Core>

namespace poinsot::view {

/** Semi-axes of the energy ellipsoid ΩᵀMΩ = 2E: √(2E/μᵢ) [rad/s], principal axes in the order of `moments` [kg·m²]. */
Eigen::Vector3d energySemiAxes(const Eigen::Vector3d& moments, double kinetic_energy);

/** Semi-axes of the momentum ellipsoid ΩᵀM²Ω = F: √F/μᵢ [rad/s]; `momentum_squared` is F = |L|² [(kg·m²/s)²]. */
Eigen::Vector3d momentumSemiAxes(const Eigen::Vector3d& moments, double momentum_squared);

}  // namespace poinsot::view
