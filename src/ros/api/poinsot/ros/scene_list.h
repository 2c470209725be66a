#pragma once

#include <string>
#include <vector>

/** The scenes that come with the package. */
namespace poinsot::node {

/** Their names, sorted; empty where the package cannot be found. */
std::vector<std::string> sceneNames();

/**
 * The file that a name or a path stands for: what has a slash or ends in .yaml is a path, all else the name of one of
 * the package's scenes. Throws std::invalid_argument for a name that is none of them, with those that are.
 */
std::string sceneFile(const std::string& name_or_path);

/** "spin" of "/any/where/spin.yaml". */
std::string sceneName(const std::string& file);

}  // namespace poinsot::node
