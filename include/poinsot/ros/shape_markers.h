#pragma once

#include <visualization_msgs/Marker.h>

#include <vector>

#include "poinsot/core/assembly.h"

namespace poinsot::node {

/**
 * The body as it looks: its solids in true size [m], in body axes, painted so that neither a turn nor a flip can be
 * overlooked. Type, pose, scale and colour are filled in; header, ns and id are left to the caller.
 */
std::vector<visualization_msgs::Marker> shapeMarkers(const Assembly& shape);

}  // namespace poinsot::node
