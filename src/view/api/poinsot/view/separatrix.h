#pragma once

#include <Eigen/Core>
#include <vector>

#include "poinsot/view/curve.h"

namespace poinsot::view {

/**
 * Returns the separatrix on the energy ellipsoid of E: the two ellipses F = 2E μ₂ that cross at the ends of the
 * intermediate axis, between the polhodes about the axis of smallest and those about the axis of largest moment. Two
 * closed curves; none when two moments are equal or E is zero.
 * @param moments [kg·m²], principal, positive, in any order.
 * @param kinetic_energy E [J], finite, not negative.
 * @param points_per_curve rounded up to a multiple of four, at least eight; spread as a polhode's are.
 */
std::vector<Curve> separatrix(const Eigen::Vector3d& moments, double kinetic_energy, int points_per_curve = 256);

}  // namespace poinsot::view
