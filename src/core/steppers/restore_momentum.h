#pragma once

#include <algorithm>

#include "compensated_sum.h"
#include "half_turn.h"
#include "poinsot/core/rotation_state.h"

namespace poinsot::steppers {

/** For methods that turn the body once a step; fewer for the others, so that about 8 turns lie between. */
constexpr int kStepsBetweenRestorations = 8;
/** The largest relative change of L at a time: the rounding errors of 8 turns. */
constexpr double kMostRestored = 4e-15;

/**
 * Undoes the drift of L by rounding since the last time: turns the attitude so that RΛ points along the conserved L,
 * and scales Λ to its length.
 *
 * Rounding alone makes RΛ drift by some 1e-18 a step, in a steady spin always the same way, and |L| by up to 5e-17.
 * With this, L stays the same to 3e-15 after any number of steps. The changes are no larger than rounding errors, too
 * small to hide a method that does not keep L.
 */
inline void restoreMomentum(FreeRotationState& state) {
  double* const q = state.attitude.coeffs().data();  // x, y, z, w
  double* const p = state.momentum_principal.data();
  double* const rest = state.momentum_rest.data();
  const double* const l = state.kept_momentum.data();
  const double x = q[0], y = q[1], z = q[2], w = q[3], p0 = p[0], p1 = p[1], p2 = p[2];
  // k = RᵀL = L − 2w v×L + 2v×(v×L), v = (x, y, z)
  const double t0 = 2 * (y * l[2] - z * l[1]), t1 = 2 * (z * l[0] - x * l[2]), t2 = 2 * (x * l[1] - y * l[0]);
  const double k0 = l[0] - w * t0 + (y * t2 - z * t1);
  const double k1 = l[1] - w * t1 + (z * t0 - x * t2);
  const double k2 = l[2] - w * t2 + (x * t1 - y * t0);

  const auto limited = [](double value) { return std::max(-kMostRestored, std::min(kMostRestored, value)); };
  // Half the rotation vector from Λ to k, small: q ← q·(1, a).
  const double scale = 0.5 * state.kept_inverse_square;
  const double a0 = limited(scale * (p1 * k2 - p2 * k1));
  const double a1 = limited(scale * (p2 * k0 - p0 * k2));
  const double a2 = limited(scale * (p0 * k1 - p1 * k0));
  q[0] = x + (w * a0 + (y * a2 - z * a1));
  q[1] = y + (w * a1 + (z * a0 - x * a2));
  q[2] = z + (w * a2 + (x * a1 - y * a0));
  q[3] = w - (x * a0 + y * a1 + z * a2);
  renormalise(state.attitude);
  if (scale == 0) return;  // at rest
  const double longer = limited(0.5 - scale * (p0 * p0 + p1 * p1 + p2 * p2));
  addCompensated(p[0], rest[0], longer * p0);
  addCompensated(p[1], rest[1], longer * p1);
  addCompensated(p[2], rest[2], longer * p2);
}

}  // namespace poinsot::steppers
