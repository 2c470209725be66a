#pragma once

#include <Eigen/Core>

namespace poinsot::view {

constexpr double kPictureRadius = 1.0;    ///< the longest semi-axis of the two ellipsoids, as drawn [m]
constexpr double kMomentumLength = 1.45;  ///< the arrow of L, as drawn [m]: its head shows outside the ellipsoids

/** The scales of a picture, chosen so that all pictures have the same size. */
struct PictureScale {
  double metres_per_radian_per_second = 1;  ///< [m/(rad/s)]
  double metres_per_angular_momentum = 1;   ///< [m/(kg·m²/s)]
};

/**
 * Returns the scale for a body with these principal moments [kg·m²] (any order) that turns with Ω [rad/s, principal
 * axes]. Both figures are positive and finite. At rest, and where one would leave the range of doubles, that one is 1.
 */
PictureScale pictureScale(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal);

/** Returns the scale at which an ellipsoid with this semi-axis [rad/s] and an L of this length [kg·m²/s] have full
 * size. */
PictureScale pictureScale(double longest_semi_axis, double momentum);

}  // namespace poinsot::view
