#pragma once

#include <Eigen/Core>
#include <vector>

namespace poinsot::view {

/** A ball that is to be seen. */
struct Ball {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [m], world axes
  double radius = 0;                                 ///< [m]
};

/** A camera that orbits a point, as RViz's Orbit view does, from +x where yaw is 0; z is up. */
struct OrbitCamera {
  double distance = 1;                              ///< of the eye from the focal point [m]
  Eigen::Vector3d focal = Eigen::Vector3d::Zero();  ///< [m], world axes
};

constexpr double kFieldOfView = 0.78539816339744831;  ///< of RViz's cameras, from the lower to the upper edge [rad]

/**
 * Returns the nearest camera with these angles that shows all of the balls, with a margin of 3 % at the edges. Where
 * there is none to show, it looks at the origin from 1 m.
 *
 * @param pitch how far it looks down [rad], in (-π/2, π/2).
 * @param yaw the eye's direction from the focal point, about z from +x [rad].
 * @param aspect width of the picture divided by its height, positive.
 */
OrbitCamera cameraThatShows(const std::vector<Ball>& balls, double pitch, double yaw, double aspect);

}  // namespace poinsot::view
