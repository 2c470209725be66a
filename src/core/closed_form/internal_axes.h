#pragma once

#include "start.h"

// Compiled once for each instruction set: see levels.h. Nothing here may be shared between them.
namespace poinsot::closed_form::POINSOT_SIMD_LEVEL {

/**
 * The axes in which the formulas are written: 2 has the intermediate moment, 3 is the one that the polhode goes round,
 * and M₁ ≥ 0, M₃ > 0. They are a signed permutation of the principal axes, and a rotation of them.
 */
struct InternalAxes {
  int from[3] = {0, 1, 2};  ///< internal axis k is principal axis from[k] …
  int sign[3] = {1, 1, 1};  ///< … or its opposite

  double moment(const Start& s, int k) const { return s.moments[from[k]]; }
  double omega(const Start& s, int k) const { return sign[k] * s.omega[from[k]]; }

  /** (x, y, z) → (z, −y, x): half a turn about (1, 0, 1). */
  void swapFirstAndThird() {
    exchange(0, 2);
    sign[1] = -sign[1];
  }

  void halfTurnAbout(int k) {
    sign[(k + 1) % 3] = -sign[(k + 1) % 3];
    sign[(k + 2) % 3] = -sign[(k + 2) % 3];
  }

  void exchange(int i, int j) {
    const int f = from[i], s = sign[i];
    from[i] = from[j], sign[i] = sign[j];
    from[j] = f, sign[j] = s;
  }
};

/** Sorts the moments in ascending order. */
inline InternalAxes ascending(const Start& s) {
  constexpr int kExchanges[] = {0, 1, 0};
  InternalAxes axes;
  for (const int i : kExchanges) {
    if (axes.moment(s, i + 1) < axes.moment(s, i)) {
      axes.exchange(i, i + 1);
      axes.sign[1] = -axes.sign[1];  // an exchange alone would be a reflection
    }
  }
  return axes;
}

}  // namespace poinsot::closed_form::POINSOT_SIMD_LEVEL
