#pragma once

#include <string>
#include <vector>

#include "hard_cases.h"
#include "poinsot/core/method.h"
#include "poinsot/core/step_limits.h"

namespace poinsot {

/** The largest errors of a method in a run of a case. */
struct Measured {
  bool finite = true;
  std::int64_t looked_at = 0;  ///< the last look: the end, or where the state was first seen infinite or NaN [steps]
  double norm = 0;             ///< ||q| − 1|
  double momentum = 0;         ///< |L − L₀|/|L₀|, world axes
  double energy = 0;           ///< |E − E₀|/E₀
  double energy_outside = 0;   ///< of E beyond [L²/2μ_max, L²/2μ_min], relative
  double energy_at_end = 0;    ///< E in that range: 0 at its lower end, 1 at its upper one
  double first_turn = 0;  ///< error of the attitude against the closed form [rad], worst rate in the first turn (or
                          ///< step, if longer) times a turn; errors below 1e-14 do not count
  double attitude = 0;    ///< greatest error of the attitude over the run [rad]
};

Measured measure(const Method& method, const HardCase& hard_case);

/** Measures the closed form at the same times, but for its attitude. */
Measured measureClosedForm(const HardCase& hard_case);

/** Bounds of the measured figures, infinite where there is none. */
struct Promise {
  double norm, momentum, energy, energy_outside, first_turn;
  bool must_be_finite;
};

/** Returns the bounds for a method, from its order, what it conserves and how its step was judged. */
Promise promiseOf(const Method& method, const HardCase& hard_case, const StepJudgement& judgement);

Promise promiseOfClosedForm(const HardCase& hard_case);

/** Returns one sentence for each bound that is exceeded. */
std::vector<std::string> broken(const Promise& promise, const Measured& measured);

/** Returns "" where a step judged hopeless did lose the motion, else what was measured instead. */
std::string wronglyRefused(const StepJudgement& judgement, const Measured& measured);

}  // namespace poinsot
