#pragma once

#include <string>
#include <vector>

#include "poinsot/SceneLayout.h"
#include "poinsot/session/moving_body.h"
#include "poinsot/view/scene_layout.h"

namespace poinsot::node {

/** Whether one of the bodies is outside of what an overview shows. */
bool hasFlownAway(const view::SceneLayout& layout, const std::vector<view::Ball>& bodies);

/**
 * Returns the message for a layout. @param pictures names of the bodies that have pictures. @param bodies as they are
 * now: where one has flown out of the layout, the message is about the bodies alone, so that a camera follows them.
 */
SceneLayout layoutMessage(const view::SceneLayout& layout, const std::vector<std::string>& pictures,
                          const std::vector<view::Ball>& bodies);

}  // namespace poinsot::node
