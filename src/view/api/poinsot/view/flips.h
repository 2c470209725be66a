#pragma once

#include <cstdint>

#include "poinsot/core/closed_form.h"
#include "poinsot/view/polhode.h"

namespace poinsot::view {

/** How often a free body has turned over, and when it does so next. */
struct Flips {
  bool flips = false;            ///< whether it turns over at any time
  std::int64_t since_start = 0;  ///< flips from t = 0 to t, the one at t included, the one at 0 not; negative for t < 0
  double to_next = 0;            ///< from t to the next flip in the direction of play [s], > 0; infinite without one
};

/**
 * Returns the flips of a free body. A flip is the instant at which Λ₂, along the axis of intermediate moment, changes
 * its sign, of a body whose axis of intermediate moment swings from less than 45° off L to less than 45° off −L. That
 * is, the largest |Λ₂|/|Λ| along the polhode is over √½. A stable spin that only wobbles has none; a body on the
 * separatrix has one in all of time, any other one every half period. For μ₁ < μ₂ < μ₃ and a polhode about axis a (1 or
 * 3), from F = |L|² and E:
 *
 *     max Λ₂²/F = μ₂ |F − 2E μ_a| / (F |μ₂ − μ_a|).
 *
 * @param t [s]; throws std::invalid_argument when it is not finite.
 * @param direction of play: negative for backwards, else forwards.
 */
Flips flipsOf(const ClosedForm& motion, double t, double direction);

/** Returns when a body on the separatrix turns over, which it does once [s]; of either sign. For no other body. */
double flipOnSeparatrix(const ClosedForm& motion);

/** Returns the largest |Λ₂|/|Λ| along the polhode, 0 … 1: 1 on the separatrix; 0 for equal moments and steady spins. */
double largestSwing(const ClosedForm& motion);

/**
 * Returns the regime in words that can follow "spins" or stand alone: "about the axis of smallest moment".
 *
 * @param moments principal moments [kg·m²].
 * @param omega_principal Ω [rad/s], principal axes; with the moments it tells which axis a steady spin is about.
 */
const char* textOf(Regime regime, const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal);

}  // namespace poinsot::view
