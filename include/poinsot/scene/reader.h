#pragma once

#include <yaml-cpp/yaml.h>

#include <stdexcept>
#include <string>

#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/** A scene that is refused. what() reads "source:line: place: what was found; what is allowed". */
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/** Reads and validates a scene file. Throws Error. */
Scene readFile(const std::string& path);

/** Reads and validates a tree that came from elsewhere. @param source stands for the file name in messages. */
Scene readTree(const YAML::Node& tree, const std::string& source);

}  // namespace poinsot::scene
