#pragma once

#include <algorithm>

#include "compensated_sum.h"
#include "half_turn.h"
#include "poinsot/core/rotation_state.h"

namespace poinsot::steppers {

/** Of methods that turn the body once a step; the others, as many steps as take about 8 turns. */
constexpr int kStepsBetweenRestorations = 8;
/** The most that L is moved at a time, relative: the rounding errors of 8 turns. */
constexpr double kMostRestored = 4e-15;

/**
 * Undoes what rounding did to L since the last time: the attitude is turned so that RΛ points along the L that is to
 * be kept, and Λ scaled to its length.
 *
 * Rounding alone makes RΛ drift by some 1e-18 a step, and always the same way in a steady spin; |L| by as much as
 * 5e-17. With this, L stays where it was to 3e-15 after any number of steps. It moves L by no more than rounding does,
 * which is too little to hide a method that does not keep L.
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
