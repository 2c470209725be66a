#pragma once

#include "place.h"
#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/** The list of what acts on a body, into the body; one line a type in the table of the implementation. */
void readEffects(const Place& place, Body& body);

}  // namespace poinsot::scene
