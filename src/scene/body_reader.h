#pragma once

#include <string>
#include <vector>

#include "place.h"
#include "poinsot/scene/reader.h"
#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/**
 * Returns the body of one entry of `bodies`. Whether its name clashes with another's is not checked here. Warnings are
 * appended.
 */
Body readBody(const Place& place, const ReadOptions& options, std::vector<std::string>& warnings);

}  // namespace poinsot::scene
