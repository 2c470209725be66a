#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "poinsot/core/closed_form.h"
#include "poinsot/ros/marker_factory.h"

namespace poinsot::node {

/**
 * What a free body's energy ellipsoid rolls on, in the picture in world axes, and never changes: the invariable plane,
 * the herpolhode on it, and by how much the body turns about L in one period of the polhode (Montgomery's angle).
 *
 * @param metres per rad/s. Lines are lifted off the plane by the same factor as a polhode off its ellipsoids, so that
 * the two lines touch where the surfaces do.
 * @param words_place where the angle is told [m], world axes.
 */
void appendRolling(const MarkerFactory& factory, const ClosedForm& motion, double metres,
                   const Eigen::Vector3d& words_place, visualization_msgs::MarkerArray& out);

}  // namespace poinsot::node
