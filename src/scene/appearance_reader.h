#pragma once

#include "place.h"
#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/** Returns what a body is drawn as. Whether a package has the mesh is checked elsewhere: ros/markers/meshes.h. */
Appearance readAppearance(const Place& place);

}  // namespace poinsot::scene
