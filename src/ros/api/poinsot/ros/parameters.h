#pragma once

#include <ros/node_handle.h>

#include <stdexcept>
#include <string>

#include "poinsot/scene/scene.h"

namespace poinsot::node {

/** The node's private parameters, validated. */
struct Parameters {
  scene::Scene scene;                 ///< under ~method, if that is set; accuracies are still to be met
  std::string scene_file;             ///< its path; empty where it came as a tree
  double rate = scene::kDefaultRate;  ///< [Hz]
  bool publish_clock = false;
  std::string frame_prefix;
};

/** A parameter that is refused; what() names it, its value and what was expected. */
class ParameterError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/**
 * Reads `~scene` (a tree) or `~scene_file` (a path), `~rate`, `~method`, `~step`, `~publish_clock` and
 * `~frame_prefix`. Throws ParameterError; scene::Error for a bad scene, rate or step; std::invalid_argument for a scene
 * that the package does not have.
 */
Parameters readParameters(const ros::NodeHandle& private_handle);

/** Throws ParameterError where the prefix makes a body's frame "world". */
void checkPrefix(const std::string& frame_prefix, const scene::Scene& scene);

}  // namespace poinsot::node
