#pragma once

#include "place.h"
#include "poinsot/core/inertia.h"

namespace poinsot::scene {

/** Three principal moments, or a 3×3 tensor (symmetric, positive definite), about the centre of mass [kg·m²]. */
PrincipalInertia readInertia(const Place& place);

}  // namespace poinsot::scene
