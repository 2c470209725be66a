#pragma once

#include <string>
#include <vector>

#include "fields.h"
#include "poinsot/scene/reader.h"
#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/**
 * The body's method and its step, from the keys `method` and `step`, or the accuracy that is wanted instead, from
 * `accuracy` and `horizon` (the longer of this and the options'); the closed form where there are none. Inertia and
 * angular velocity are read already: a step that is hopeless for this body is refused, of a doubtful one a warning is
 * appended.
 */
void readMethod(const Fields& fields, const ReadOptions& options, Body& body, std::vector<std::string>& warnings);

}  // namespace poinsot::scene
