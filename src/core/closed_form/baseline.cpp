#define POINSOT_SIMD_LEVEL baseline
#include "level.h"

const poinsot::closed_form::Level poinsot::closed_form::kBaseline = {
    "baseline", baseline::prepare, baseline::phases, baseline::at, baseline::atPhases, baseline::sample};
