#pragma once

#include <string>
#include <vector>

/** The scenes that come with the package. */
namespace poinsot::node {

/** Returns their names, sorted; none where the package cannot be found. */
std::vector<std::string> sceneNames();

/**
 * Returns the file that a name or a path stands for: what has a slash or ends in .yaml is a path, all else the name of
 * one of the package's scenes. Throws std::invalid_argument for another name, with the names of the scenes.
 */
std::string sceneFile(const std::string& name_or_path);

/**
 * Throws std::invalid_argument, with the names of the scenes, where the path is that of one of the package's scenes and
 * there is none of this name. Any other path is left to whoever reads it.
 */
void requireKnownScene(const std::string& path);

/** Returns "spin" for "/any/where/spin.yaml". */
std::string sceneName(const std::string& file);

}  // namespace poinsot::node
