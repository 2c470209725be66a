#pragma once

#include "place.h"
#include "poinsot/core/assembly.h"

namespace poinsot::scene {

/** `{type: box, size: [..], mass: ..}` and its like; one line a type in the table of the implementation. */
Assembly readShape(const Place& place);

}  // namespace poinsot::scene
