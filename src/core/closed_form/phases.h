#pragma once

#include "discriminant.h"
#include "double_double.h"
#include "levels.h"
#include "series.h"

// Compiled once for each instruction set: see levels.h. Nothing here may be shared between them.
namespace poinsot::closed_form::POINSOT_SIMD_LEVEL {

inline DoubleDouble operator*(const Pair& a, const DoubleDouble& b) {
  return DoubleDouble(a.high, a.low) * b;
}

inline Pair wrapped(const DoubleDouble& phase, double period) {
  const double whole = period * __builtin_rint(phase.high / period);
  return asPair(exactSum(phase.high - whole, phase.low));
}

inline Pair clamped(const DoubleDouble& phase) {
  if (phase.high > kFarAlong) return {kFarAlong, 0};
  if (phase.high < -kFarAlong) return {-kFarAlong, 0};
  return asPair(phase);
}

/** @param t scaled time. A turn of v by 2 is a period of Ω. */
inline Phases phasesAt(const Constants& c, const DoubleDouble& t) {
  const DoubleDouble half = DoubleDouble(c.start.half.high, c.start.half.low) + c.rate.half * t;
  return {c.kind == Constants::Kind::separatrix ? clamped(half) : wrapped(half, 2), wrapped(c.rate.turn * t, 1)};
}

inline double scaledTime(const Constants& c, double t) {
  return t * c.time_scale;
}

/** Returns rate·t + start without the final sums, because the series take a phase in two parts. */
inline SplitPhase phaseAt(const Pair& rate, double t, const Pair& start) {
  const DoubleDouble product = exactProduct(rate.high, t);
  const DoubleDouble sum = exactSum(product.high, start.high);
  return {sum.high, sum.low + (mulAdd(rate.low, t, product.low) + start.low)};
}

}  // namespace poinsot::closed_form::POINSOT_SIMD_LEVEL
