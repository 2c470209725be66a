#pragma once

#include <Eigen/Core>

namespace poinsot::view {

/** The quantity that two spins have in common. */
enum class ConservedQuantity {
  energy,   ///< E: Ω stays on the energy ellipsoid
  momentum  ///< |L|: Ω stays on the momentum ellipsoid
};

/** The axes of a body by their moments. */
enum class Axis { smallest, intermediate, largest };

// Spins of a body with these principal moments [kg·m²] (any order) that have E or |L| of `omega` [rad/s, principal
// axes; finite, not zero]. They are of the size of `omega`, so that none leaves the range of doubles, and turn about
// each axis in the same sense.

/** Returns the semi-axes [rad/s] of the ellipsoid on which the quantity is constant. */
Eigen::Vector3d keptSemiAxes(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega, ConservedQuantity keep);

/** Returns the spin exactly about an axis. */
Eigen::Vector3d axisSpin(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega, ConservedQuantity keep,
                         Axis axis);

/**
 * Returns a spin near an axis: 12° off the smallest or the largest, towards the intermediate one, so that Ω goes round
 * it; 1.5° off the intermediate one, towards the largest, so that the body flips. (Angles as seen on the ellipsoid
 * drawn as a sphere.)
 */
Eigen::Vector3d nearAxis(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega, ConservedQuantity keep,
                         Axis axis);

/**
 * Returns a spin on the separatrix, μ₃(μ₃−μ₂)Ω₃² = μ₁(μ₂−μ₁)Ω₁², 15° off the end of the intermediate axis that it
 * leaves: nearly as close to the separatrix as doubles can be, so that the body flips once and then not for a long
 * time. Throws std::invalid_argument when two moments are equal, because there is no separatrix.
 */
Eigen::Vector3d onSeparatrix(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega, ConservedQuantity keep);

}  // namespace poinsot::view
