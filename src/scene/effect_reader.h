#pragma once

#include "place.h"
#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/** Reads the list of what acts on a body into the body. The table of the implementation has one line for each type. */
void readEffects(const Place& place, Body& body);

}  // namespace poinsot::scene
