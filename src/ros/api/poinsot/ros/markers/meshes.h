#pragma once

#include <string>

#include "poinsot/scene/scene.h"

namespace poinsot::node {

/**
 * Throws scene::Error where a body's mesh is missing on this machine: an unknown package, or no such file in it. RViz
 * looks for it by itself.
 */
void requireMeshes(const scene::Scene& scene);

/**
 * Returns the address by which RViz finds a mesh: `mesh` itself, unless the path of its file has a blank. Then it is
 * that of the file on this machine, with %20 for the blank: RViz would put a package's path into an address as it is,
 * and find nothing.
 */
std::string meshAddress(const std::string& mesh);

}  // namespace poinsot::node
