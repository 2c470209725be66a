#pragma once

#include <string>

#include "poinsot/scene/scene.h"

/** Words for what a scene has, its accuracies met: methods, steps, regimes. */
namespace poinsot::node {

/** Where and how a scene is played. */
struct Stage {
  std::string scene;         ///< its name and file, or the parameter that holds its tree
  double rate = 0;           ///< [Hz]
  std::string name_space;    ///< of the topics
  std::string frame_prefix;  ///< may be empty
};

/** Returns one line: what plays, how often states are published, where, and the method and step of each body. */
std::string playedText(const scene::Scene& scene, const Stage& stage);

/**
 * Returns what a check has found: a line for each body with its method, step and regime, and last "no fault", with the
 * number of warnings where there are any. Of many bodies, both texts name the first.
 */
std::string checkedText(const scene::Scene& scene);

}  // namespace poinsot::node
