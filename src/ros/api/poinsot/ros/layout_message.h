#pragma once

#include <string>
#include <vector>

#include "poinsot/SceneLayout.h"
#include "poinsot/view/scene_layout.h"

namespace poinsot::node {

/** A body, for the message about the layout. */
struct LaidOut {
  std::string name, frame;
  bool has_pictures;
  view::Ball now;  ///< what holds it now
};

/** Returns whether one of the bodies is outside of what an overview shows. */
bool hasFlownAway(const view::SceneLayout& layout, const std::vector<LaidOut>& bodies);

/**
 * Returns the message for a layout. Where a body has flown out of it, the balls are those of the bodies alone, so that
 * a camera follows them.
 */
SceneLayout layoutMessage(const view::SceneLayout& layout, const std::vector<LaidOut>& bodies);

}  // namespace poinsot::node
