#pragma once

#include "place.h"
#include "poinsot/core/inertia.h"

namespace poinsot::scene {

/** Returns the inertia [kg·m²] of three principal moments, or of a symmetric positive definite 3×3 tensor. */
PrincipalInertia readInertia(const Place& place);

}  // namespace poinsot::scene
