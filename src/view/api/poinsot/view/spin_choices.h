#pragma once

#include <Eigen/Core>

namespace poinsot::view {

/** What a spin keeps of another one. */
enum class ConservedQuantity {
  energy,   ///< E: Ω stays on the energy ellipsoid
  momentum  ///< |L|: Ω stays on the momentum ellipsoid
};

/** Axes of a body by its moments. */
enum class Axis { smallest, intermediate, largest };

/**
 * Spins to choose from, for a body with these principal moments [kg·m²] (any order), that keep E or |L| of `omega`
 * [rad/s, principal axes; finite, not zero]. All are of the size of omega: nothing leaves the range of doubles that was
 * in it. Each turns about its axis in the sense in which `omega` does.
 */

/** Semi-axes [rad/s] of the ellipsoid on which Ω may be led. */
Eigen::Vector3d keptSemiAxes(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega, ConservedQuantity keep);

/** Exactly about an axis. */
Eigen::Vector3d axisSpin(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega, ConservedQuantity keep,
                         Axis axis);

/**
 * Near an axis: 12° off the smallest or the largest, towards the intermediate one, so that Ω goes round it; 1.5° off
 * the intermediate one, towards the largest, so that the body flips. (Angles as seen on the ellipsoid drawn as a
 * sphere.)
 */
Eigen::Vector3d nearAxis(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega, ConservedQuantity keep,
                         Axis axis);

/**
 * On the separatrix, μ₃(μ₃−μ₂)Ω₃² = μ₁(μ₂−μ₁)Ω₁², 15° off the end of the intermediate axis that it leaves: about as
 * near to it as doubles come, so that the body flips once and, roundoff permitting, not again for a long time. Throws
 * std::invalid_argument when two moments are equal: there is none.
 */
Eigen::Vector3d onSeparatrix(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega, ConservedQuantity keep);

}  // namespace poinsot::view
