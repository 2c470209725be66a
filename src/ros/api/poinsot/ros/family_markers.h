#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>

#include "poinsot/core/inertia.h"
#include "poinsot/ros/marker_factory.h"

namespace poinsot::node {

/**
 * The family of polhodes with the |L| of this spin, on the momentum ellipsoid of the picture in body axes: its members
 * in one list of lines (id 0), and the separatrices of that |L| in another (id 1). Where the energy ellipsoid is
 * outside, it hides them. Nothing for three equal moments.
 *
 * @param omega_principal Ω [rad/s].
 * @param metres per rad/s.
 */
void appendFamily(const MarkerFactory& factory, const PrincipalInertia& inertia, const Eigen::Vector3d& omega_principal,
                  double metres, visualization_msgs::MarkerArray& out);

}  // namespace poinsot::node
