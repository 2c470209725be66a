// Compiled for AVX2 and FMA; empty where the compiler is not told so, on other processors.
#ifdef __AVX2__
#define POINSOT_SIMD_LEVEL x86_64_v3
#include "level.h"

const poinsot::closed_form::Level poinsot::closed_form::kV3 = {"x86-64-v3",   x86_64_v3::prepare,  x86_64_v3::phases,
                                                               x86_64_v3::at, x86_64_v3::atPhases, x86_64_v3::sample};
#endif
