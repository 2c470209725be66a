// The hot code as one Level. Included by one source file for each instruction set, which defines POINSOT_SIMD_LEVEL.
#include "kernel.h"
#include "levels.h"
#include "set_up.h"

namespace poinsot::closed_form {
namespace POINSOT_SIMD_LEVEL {

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

inline bool isNear(const Constants& c, double scaled_time) {
  const double distance = magnitude(scaled_time);
  return distance * magnitude(c.rate.turn.high) < kMostTurns &&
         (c.kind == Constants::Kind::separatrix || distance * magnitude(c.rate.half.high) < kMostTurns);
}

inline double scaledTime(const Constants& c, double t) {
  return (t * c.time_scale[0]) * c.time_scale[1];
}

bool phases(const Constants& c, double t, Phases& out) {
  const double time = scaledTime(c, t);
  if (!isNear(c, time)) return false;
  out = phasesAt(c, time);
  return true;
}

bool at(const Constants& c, double t, double state[7]) {
  Phases phases;
  if (!poinsot::closed_form::POINSOT_SIMD_LEVEL::phases(c, t, phases)) return false;
  const Evaluation e = evaluate(c, splitPhase(phases.half), splitPhase(phases.turn));
  for (int i = 0; i < 4; ++i) state[i] = e.attitude[i];
  for (int i = 0; i < 3; ++i) state[4 + i] = c.omega[i] * e.omega[c.from[i]];
  return true;
}

template <bool kHyperbolic>
void evaluateBlock(const Constants& c, const Phases& base, const Phases& step, int n, double* const columns[7]) {
  alignas(64) double attitude[4][kBlock], omega[3][kBlock];
  const SplitPhase half = splitPhase(base.half), turn = splitPhase(base.turn);
  const SplitPhase half_step = splitPhase(step.half), turn_step = splitPhase(step.turn);
  for (int j = 0; j < n; ++j) {
    const SplitPhase v{mulAdd(j, half_step.grid, half.grid), mulAdd(j, half_step.rest, half.rest)};
    const SplitPhase f{mulAdd(j, turn_step.grid, turn.grid), mulAdd(j, turn_step.rest, turn.rest)};
    const Evaluation e = kHyperbolic ? hyperbolic(c, v, f) : trigonometric(c, v, f);
    for (int i = 0; i < 4; ++i) attitude[i][j] = e.attitude[i];
    for (int i = 0; i < 3; ++i) omega[i][j] = e.omega[i];
  }
  for (int i = 0; i < 4; ++i) __builtin_memcpy(columns[i], attitude[i], n * sizeof(double));
  for (int i = 0; i < 3; ++i) {
    const double* source = omega[c.from[i]];
    for (int j = 0; j < n; ++j) columns[4 + i][j] = c.omega[i] * source[j];
  }
}

void block(const Constants& c, const Phases& base, const Phases& step, int n, double* const columns[7]) {
  if (c.series == Constants::Series::hyperbolic) {
    evaluateBlock<true>(c, base, step, n, columns);
  } else {
    evaluateBlock<false>(c, base, step, n, columns);
  }
}

bool sample(const Constants& c, double t0, double dt, long n, double* const columns[7]) {
  if (n <= 0) return true;
  const double begin = scaledTime(c, t0), step_time = scaledTime(c, dt);
  if (!isNear(c, begin) || !isNear(c, begin + static_cast<double>(n) * step_time)) return false;
  const auto timeOf = [&](long j) { return exactProduct(static_cast<double>(j), step_time) + begin; };
  Phases step{wrapped(c.rate.half * DoubleDouble(step_time), 2), wrapped(c.rate.turn * DoubleDouble(step_time), 1)};
  int size = kBlock;
  if (c.kind == Constants::Kind::separatrix) {
    // Its phase does not wrap: blocks only where one is short enough for exact multiples.
    const DoubleDouble half = c.rate.half * DoubleDouble(step_time);
    if (magnitude(half.high) * kBlock > kFarAlong) size = 1;
    step.half = size == 1 ? Pair{} : asPair(half);
  }
  for (long first = 0; first < n; first += size) {
    double* rest[7];
    for (int i = 0; i < 7; ++i) rest[i] = columns[i] + first;
    block(c, phasesAt(c, timeOf(first)), step, n - first < size ? static_cast<int>(n - first) : size, rest);
  }
  return true;
}

void prepare(const Start& start, Constants& constants) {
  setUp<DoubleDouble>(start, constants);
}

}  // namespace POINSOT_SIMD_LEVEL
}  // namespace poinsot::closed_form
