#pragma once

#include "poinsot/core/closed_form_constants.h"
#include "start.h"

namespace poinsot::closed_form {

/**
 * The hot code for one instruction set. The same headers are compiled once for each, in a namespace of its name
 * (POINSOT_SIMD_LEVEL): of a shared inline function the linker would keep one for all, perhaps that of a newer
 * processor.
 */
struct Level {
  const char* name;

  /** For starts that isOrdinary() accepts. */
  void (*set_up)(const Start& start, Constants& constants);

  /** Sets reduced phases: half to two half-periods (bounded on the separatrix), turn to one turn. False as below. */
  bool (*phases)(const Constants& constants, double t, Phases& out);

  /** Sets the state; attitude as x, y, z, w. Returns false, with nothing set, beyond Constants::reach. */
  bool (*at)(const Constants& constants, double t, double* attitude, double* omega);

  /** Sets the state at reduced phases. */
  void (*at_phases)(const Constants& constants, const Phases& phases, double* attitude, double* omega);

  /** Writes the states at t0 + j·dt, j = 0 … n−1: w, x, y, z, Ω₁, Ω₂, Ω₃ into columns[quantity][j]. False as above. */
  bool (*sample)(const Constants& constants, double t0, double dt, long n, double* const columns[7]);
};

/** Where the phase along the separatrix, which does not wrap, is as good as infinite. */
constexpr double kFarAlong = 16;

extern const Level kBaseline, kV3, kV4;

/**
 * Returns the best level that this processor has, but none above that in the environment variable POINSOT_SIMD
 * (baseline, x86-64-v3, x86-64-v4), if that is set at the first call.
 */
const Level& bestLevel();

}  // namespace poinsot::closed_form
