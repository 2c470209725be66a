#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "poinsot/core/closed_form.h"
#include "poinsot/core/inertia.h"
#include "poinsot/ros/marker_factory.h"

namespace poinsot::node {

/**
 * The body cone and the space cone of a free body with two equal moments, in the picture in world axes: mantles whose
 * apex is the centre, with a rim and some lines down to the apex. The one stands still in the body, the other in the
 * world; the first rolls on the second. Nothing for other bodies.
 */
void appendCones(const MarkerFactory& factory, const ClosedForm& motion, const PrincipalInertia& inertia, double metres,
                 visualization_msgs::MarkerArray& out);

}  // namespace poinsot::node
