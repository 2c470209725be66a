#pragma once

#include <Eigen/Core>
#include <vector>

#include "poinsot/view/curve.h"

namespace poinsot::view {

/** The kind of curve on which Ω moves in the body. */
enum class Regime {
  about_smallest,  ///< a loop about the axis of smallest moment
  about_largest,   ///< a loop about the axis of largest moment
  separatrix,      ///< half an ellipse from one end of the intermediate axis to the other
  circle,          ///< two moments are equal: a circle about the third axis
  axis_spin,       ///< steady spin about a principal axis (of a body that is not spherical): a point
  sphere,          ///< three equal moments: every spin is steady, there is no curve
  rest             ///< Ω = 0
};

/** The polhode: the intersection of the energy ellipsoid and the momentum ellipsoid. */
struct Polhode {
  Regime regime = Regime::rest;
  /**
   * First the curve of Ω itself, then its mirror image −Ω (point by point), then, on the separatrix, the two arcs of
   * the other plane. Loops and circles are closed; arcs of the separatrix are open and include their ends; an axis spin
   * has single points; sphere and rest have none.
   */
  std::vector<Curve> branches;
};

/**
 * Returns the polhode through Ω, from the ellipsoids' equations (no integration).
 *
 * Sizes come from sums of positive terms, never from 2EI − F by subtraction, so that every point lies on both
 * ellipsoids to roundoff also near the separatrix. Points are spread nearly evenly in arc length, denser where the
 * curve turns, and lie where it meets the planes of symmetry, where the corners of a polhode near the separatrix are.
 *
 * Equal moments and zero components are tested exactly. Otherwise the sign of
 *   F − 2E μ₂ = μ₃(μ₃−μ₂)Ω₃² − μ₁(μ₂−μ₁)Ω₁²,   μ₁ < μ₂ < μ₃,
 * decides; where roundoff makes that wrong, the picture is the same.
 *
 * @param moments [kg·m²], principal, positive, in any order; the triangle inequality is not needed.
 * @param omega_principal Ω [rad/s], principal axes in the same order, finite, of any size.
 * @param points_per_branch rounded up to a multiple of four, at least eight (one more on an open arc).
 */
Polhode polhode(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal, int points_per_branch = 256);

}  // namespace poinsot::view
