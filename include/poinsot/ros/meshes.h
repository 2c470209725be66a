#pragma once

#include "poinsot/scene/scene.h"

namespace poinsot::node {

/**
 * Throws scene::Error where a body's mesh is not there: an unknown package, or no such file in it. Looked up on this
 * machine; RViz looks for it on its own.
 */
void requireMeshes(const scene::Scene& scene);

}  // namespace poinsot::node
