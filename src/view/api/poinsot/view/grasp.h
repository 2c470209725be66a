#pragma once

#include <Eigen/Core>
#include <optional>

namespace poinsot::view {

/**
 * Returns the point of an ellipsoid about the origin in the direction of `point`; nothing where `point` is the origin
 * or not finite. The semi-axes lie along the axes of coordinates, positive and finite.
 */
std::optional<Eigen::Vector3d> pointTowards(const Eigen::Vector3d& semi_axes, const Eigen::Vector3d& point);

/**
 * Returns the point of the same ellipsoid that an eye outside sees at `point`: the nearer of the two points on the line
 * of sight; where that passes by, the point of the rim in the plane of the line and the centre. So a hand that moves
 * `point` on the screen moves the result over the visible half, and along its rim outside of it. With the eye inside it
 * is pointTowards(). Nothing where `point` is not finite or is the eye.
 */
std::optional<Eigen::Vector3d> pointInSight(const Eigen::Vector3d& semi_axes, const Eigen::Vector3d& eye,
                                            const Eigen::Vector3d& point);

}  // namespace poinsot::view
