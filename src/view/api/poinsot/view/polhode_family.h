#pragma once

#include <Eigen/Core>
#include <vector>

#include "poinsot/view/curve.h"

namespace poinsot::view {

/** The polhodes that Ω could run through with the same |L|: all on one momentum ellipsoid, each with an energy of its
 * own. */
struct PolhodeFamily {
  std::vector<Curve> members;     ///< closed, in pairs of mirror images
  std::vector<Curve> separatrix;  ///< of that |L|: two ellipses that cross at the ends of the intermediate axis
};

/**
 * Members cross the plane of the axes of smallest and largest moment at steps of nearly `spacing` along the momentum
 * ellipsoid, from the end of either axis to the separatrix; at least one on either side. The one that would run beside
 * the polhode of E, closer than half a step, is left out. With two equal moments: circles from the third axis to the
 * equator, and no separatrix. Nothing for three equal moments and at rest.
 *
 * @param moments [kg·m²], principal, positive, in any order.
 * @param omega_principal Ω [rad/s], whose |L| they have, and whose polhode they leave room for.
 * @param spacing relative to the longest semi-axis.
 * @param tolerance how far a line between two points may stray from the curve, relative to the longest semi-axis.
 */
PolhodeFamily polhodeFamily(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal,
                            double spacing = 0.17, double tolerance = 2e-3);

}  // namespace poinsot::view
