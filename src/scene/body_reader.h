#pragma once

#include <string>
#include <vector>

#include "place.h"
#include "poinsot/scene/reader.h"
#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/** One entry of `bodies`, all but whether its name clashes with another's. Warnings are appended. */
Body readBody(const Place& place, const ReadOptions& options, std::vector<std::string>& warnings);

}  // namespace poinsot::scene
