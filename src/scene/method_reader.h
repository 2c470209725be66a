#pragma once

#include "fields.h"
#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/** The body's method and its step, from the keys `method` and `step`, or the defaults. */
void readMethod(const Fields& fields, Body& body);

}  // namespace poinsot::scene
