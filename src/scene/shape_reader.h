#pragma once

#include "place.h"
#include "poinsot/core/assembly.h"

namespace poinsot::scene {

/** What lengths and masses must be besides positive and finite. */
constexpr const char* kExpectedSizes = "lengths and masses whose volumes and moments doubles can hold";

/** Returns the solids of `{type: box, size: [..], mass: ..}`, or of another type in the table of the implementation. */
Assembly readShape(const Place& place);

}  // namespace poinsot::scene
