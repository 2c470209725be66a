#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "poinsot/scene/scene.h"
#include "poinsot/view/camera.h"
#include "poinsot/view/scene_layout.h"

namespace poinsot::node {

/** Appends what a scene draws besides its bodies, in the namespaces /line and /text. @param light the background. */
void appendDrawings(const std::vector<scene::Drawing>& drawings, const view::SceneLayout& layout, bool light,
                    visualization_msgs::MarkerArray& out);

/** Appends what holds the drawings to what an overview is to show. */
void extendOverview(const std::vector<scene::Drawing>& drawings, view::SceneLayout& layout);

}  // namespace poinsot::node
