#pragma once

#include "poinsot/core/closed_form_constants.h"
#include "start.h"

namespace poinsot::closed_form {

/**
 * The hot code for one instruction set. The same headers are compiled once for each, all in a namespace of its name
 * (POINSOT_SIMD_LEVEL): were an inline function shared between them, the linker would keep one for all, and might keep
 * that of a newer processor.
 */
struct Level {
  const char* name;

  /** For starts that isOrdinary() accepts. */
  void (*set_up)(const Start& start, Constants& constants);

  /** Reduced: half to two half-periods, turn to one turn; on the separatrix half is cut off far out. False as below. */
  bool (*phases)(const Constants& constants, double t, Phases& out);

  /** The state; attitude as x, y, z, w. False, and nothing done, beyond Constants::reach. */
  bool (*at)(const Constants& constants, double t, double* attitude, double* omega);

  /** The state at phases that are reduced. */
  void (*at_phases)(const Constants& constants, const Phases& phases, double* attitude, double* omega);

  /** States at t0 + j·dt, j = 0 … n−1: w, x, y, z, Ω₁, Ω₂, Ω₃ into columns[quantity][j]. False as above. */
  bool (*sample)(const Constants& constants, double t0, double dt, long n, double* const columns[7]);
};

/** Where the phase along the separatrix, which does not wrap, is as good as infinite. */
constexpr double kFarAlong = 16;

extern const Level kBaseline, kV3, kV4;

/**
 * The best level that this processor has; no better than the environment variable POINSOT_SIMD (baseline, x86-64-v3,
 * x86-64-v4) says, if it is set when this is first called.
 */
const Level& bestLevel();

}  // namespace poinsot::closed_form
