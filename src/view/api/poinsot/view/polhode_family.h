#pragma once

#include <Eigen/Core>
#include <vector>

#include "poinsot/view/curve.h"

namespace poinsot::view {

/** Polhodes of the same |L|, all on one momentum ellipsoid, each of another energy. */
struct PolhodeFamily {
  std::vector<Curve> members;     ///< closed, in pairs of mirror images
  std::vector<Curve> separatrix;  ///< of that |L|: two ellipses that cross at the ends of the intermediate axis
};

/**
 * Returns the family of |L|. Its members cross the plane of the axes of smallest and largest moment at steps of nearly
 * `spacing` along the momentum ellipsoid, from the end of either axis to the separatrix; at least one on either side. A
 * member closer than half a step to the polhode of Ω is left out. With two equal moments they are circles from the
 * third axis to the equator, without a separatrix. Empty for three equal moments and at rest.
 *
 * @param moments [kg·m²], principal, positive, in any order.
 * @param omega_principal Ω [rad/s], which gives |L|.
 * @param spacing relative to the longest semi-axis.
 * @param tolerance how far a line between two points may stray from the curve, relative to the longest semi-axis.
 */
PolhodeFamily polhodeFamily(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal,
                            double spacing = 0.17, double tolerance = 2e-3);

}  // namespace poinsot::view
