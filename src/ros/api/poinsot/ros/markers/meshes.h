#pragma once

#include <string>

#include "poinsot/scene/scene.h"

namespace poinsot::node {

/**
 * Throws scene::Error where a body's mesh is not there: an unknown package, or no such file in it. Looked up on this
 * machine; RViz looks for it on its own.
 */
void requireMeshes(const scene::Scene& scene);

/**
 * The address by which RViz finds a mesh: `mesh` itself, unless the path of its file has a blank. Then it is that of
 * the file on this machine, with the blank as %20: RViz puts a package's path into an address as it stands, and gets
 * nothing.
 */
std::string meshAddress(const std::string& mesh);

}  // namespace poinsot::node
