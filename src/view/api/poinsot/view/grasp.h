#pragma once

#include <Eigen/Core>
#include <optional>

namespace poinsot::view {

/**
 * The point of an ellipsoid about the origin that lies in the direction of `point`. Semi-axes along the axes of
 * coordinates, positive and finite. Nothing where there is no direction: `point` at the origin, or not finite.
 */
std::optional<Eigen::Vector3d> pointTowards(const Eigen::Vector3d& semi_axes, const Eigen::Vector3d& point);

/**
 * The point of the same ellipsoid that an eye outside sees at `point`: the nearer of the two where the line of sight
 * meets it; where it passes by, the point of the rim in the plane of that line and the centre. So a hand that leads
 * `point` about on the screen leads it over the visible half, and along its rim when it leaves that. With the eye
 * inside, pointTowards(). Nothing where `point` is not finite or is the eye.
 */
std::optional<Eigen::Vector3d> pointInSight(const Eigen::Vector3d& semi_axes, const Eigen::Vector3d& eye,
                                            const Eigen::Vector3d& point);

}  // namespace poinsot::view
