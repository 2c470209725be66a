#pragma once

#include "place.h"
#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/** What a body is drawn as. Whether a package has the mesh is not known here: ros/markers/meshes.h. */
Appearance readAppearance(const Place& place);

}  // namespace poinsot::scene
