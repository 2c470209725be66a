#pragma once

#include "compensated_sum.h"
#include "half_turn.h"
#include "poinsot/core/rotation_state.h"

namespace poinsot::steppers {

/**
 * The move of all Lie-group methods: the body turns by the rotation vector θ (body axes) while L stays,
 *   q ← q·exp(θ),  Λ ← exp(−θ)Λ = Λ − (sin|θ|/|θ|) θ×Λ + ((1 − cos|θ|)/|θ|²) θ×(θ×Λ).
 * The increments of Λ are summed with compensation.
 *
 * Component by component: vector instructions that reload what was just stored piecewise would take twice the time.
 *
 * @param turn exp(θ), for methods that know it without a sine.
 */
inline void rotate(FreeRotationState& state, const Eigen::Vector3d& theta, const HalfTurn& turn) {
  const double v0 = theta[0], v1 = theta[1], v2 = theta[2];
  double* const p = state.momentum_principal.data();
  double* const rest = state.momentum_rest.data();
  const double p0 = p[0], p1 = p[1], p2 = p[2];
  // θ×Λ and θ×(θ×Λ) do not wait for c and s.
  const double u0 = v1 * p2 - v2 * p1, u1 = v2 * p0 - v0 * p2, u2 = v0 * p1 - v1 * p0;
  const double uu0 = v1 * u2 - v2 * u1, uu1 = v2 * u0 - v0 * u2, uu2 = v0 * u1 - v1 * u0;
  const double once = turn.c * turn.s, twice = 0.5 * turn.s * turn.s;
  addCompensated(p[0], rest[0], twice * uu0 - once * u0);
  addCompensated(p[1], rest[1], twice * uu1 - once * u1);
  addCompensated(p[2], rest[2], twice * uu2 - once * u2);

  double* const q = state.attitude.coeffs().data();  // x, y, z, w
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  const double half = 0.5 * turn.s, c = turn.c, b0 = half * v0, b1 = half * v1, b2 = half * v2;
  const double nw = (w * c - x * b0) - (y * b1 + z * b2);
  const double nx = (w * b0 + x * c) + (y * b2 - z * b1);
  const double ny = (w * b1 + y * c) + (z * b0 - x * b2);
  const double nz = (w * b2 + z * c) + (x * b1 - y * b0);
  const double unit = 1.5 - 0.5 * ((nw * nw + nx * nx) + (ny * ny + nz * nz));  // one Newton step, see renormalise()
  q[0] = unit * nx;
  q[1] = unit * ny;
  q[2] = unit * nz;
  q[3] = unit * nw;
}

inline void rotate(FreeRotationState& state, const Eigen::Vector3d& theta) {
  rotate(state, theta, halfTurn(theta));
}

/** Returns exp(−θ)Λ: Λ seen from the body after it has turned by θ. Out of line, a step of rkmk4 would take half as
 * long again. */
[[gnu::always_inline]] inline Eigen::Vector3d turnedBack(const Eigen::Vector3d& momentum,
                                                         const Eigen::Vector3d& theta) {
  const HalfTurn turn = halfTurn(theta);
  const Eigen::Vector3d once = theta.cross(momentum);
  return momentum + (0.5 * turn.s * turn.s) * theta.cross(once) - (turn.c * turn.s) * once;
}

}  // namespace poinsot::steppers
