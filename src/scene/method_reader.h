#pragma once

#include <string>
#include <vector>

#include "fields.h"
#include "poinsot/scene/reader.h"
#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/**
 * Reads the body's method and step from the keys `method` and `step`, or the requested accuracy from `accuracy` and
 * `horizon` (the longer of this and the options'); where there are none, the body gets the closed form. Inertia and
 * angular velocity must be read already: a step that is hopeless for this body is refused, and a doubtful one gives a
 * warning.
 */
void readMethod(const Fields& fields, const ReadOptions& options, Body& body, std::vector<std::string>& warnings);

}  // namespace poinsot::scene
