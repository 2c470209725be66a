#pragma once

#include <visualization_msgs/Marker.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "poinsot/core/assembly.h"
#include "poinsot/scene/scene.h"

namespace poinsot::node {

/**
 * The body as it looks: a mesh, or else its solids in true size [m], in body axes, painted so that neither a turn nor
 * a flip can be overlooked. Type, id, pose, scale and colour are filled in; header and ns are left to the caller.
 * @param centre of mass of the shape, body axes [m].
 */
std::vector<visualization_msgs::Marker> shapeMarkers(const std::optional<scene::Appearance>& appearance,
                                                     const Assembly& shape, const Eigen::Vector3d& centre);

}  // namespace poinsot::node
