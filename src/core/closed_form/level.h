// The hot code as one Level. Included by one source file for each instruction set, which defines POINSOT_SIMD_LEVEL.
#include "grid.h"
#include "levels.h"
#include "set_up.h"

namespace poinsot::closed_form {
namespace POINSOT_SIMD_LEVEL {

bool phases(const Constants& c, double t, Phases& out) {
  const double time = scaledTime(c, t);
  if (!(magnitude(time) < c.reach)) return false;
  out = phasesAt(c, time);
  return true;
}

inline void store(const Constants& c, const Evaluation& e, double* attitude, double* omega) {
  attitude[0] = e.attitude[1];
  attitude[1] = e.attitude[2];
  attitude[2] = e.attitude[3];
  attitude[3] = e.attitude[0];
  for (int i = 0; i < 3; ++i) omega[i] = c.omega_unit * (c.omega[i] * e.omega[c.from[i]]);
}

bool at(const Constants& c, double t, double* attitude, double* omega) {
  const double time = scaledTime(c, t);
  if (!(magnitude(time) < c.reach)) return false;
  const DoubleDouble turn = exactProduct(c.rate.turn.high, time);
  store(c, evaluate(c, phaseAt(c.rate.half, time, c.start.half), {turn.high, mulAdd(c.rate.turn.low, time, turn.low)}),
        attitude, omega);
  return true;
}

void atPhases(const Constants& c, const Phases& phases, double* attitude, double* omega) {
  store(c, evaluate(c, splitPhase(phases.half), splitPhase(phases.turn)), attitude, omega);
}

bool sample(const Constants& c, double t0, double dt, long n, double* const columns[7]) {
  const double begin = scaledTime(c, t0), step = scaledTime(c, dt);
  const double end = begin + static_cast<double>(n) * step;
  if (!(magnitude(begin) < c.reach) || !(magnitude(end) < c.reach)) return false;
  Grid(c, begin, step, n, columns).run();
  return true;
}

void prepare(const Start& start, Constants& constants) {
  setUp<DoubleDouble>(start, constants);
}

}  // namespace POINSOT_SIMD_LEVEL
}  // namespace poinsot::closed_form
