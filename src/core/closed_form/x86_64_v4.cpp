// Compiled for AVX-512; empty where the compiler is not told so, on other processors.
#ifdef __AVX512F__
#define POINSOT_SIMD_LEVEL x86_64_v4
#include "level.h"

const poinsot::closed_form::Level poinsot::closed_form::kV4 = {"x86-64-v4",   x86_64_v4::prepare,  x86_64_v4::phases,
                                                               x86_64_v4::at, x86_64_v4::atPhases, x86_64_v4::sample};
#endif
