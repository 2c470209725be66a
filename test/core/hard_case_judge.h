#pragma once

#include <string>
#include <vector>

#include "hard_cases.h"
#include "poinsot/core/method.h"
#include "poinsot/core/step_limits.h"

namespace poinsot {

/** What a method did with a case: the greatest figures over the run. */
struct Measured {
  bool finite = true;
  std::int64_t looked_at = 0;  ///< the last look: the end, or where the state was first seen infinite or NaN [steps]
  double norm = 0;             ///< ||q| − 1|
  double momentum = 0;         ///< |L − L₀|/|L₀|, world axes
  double energy = 0;           ///< |E − E₀|/E₀
  double energy_outside = 0;   ///< of E beyond [L²/2μ_max, L²/2μ_min], relative
  double energy_at_end = 0;    ///< E in that range: 0 at its lower end, 1 at its upper one
  double first_turn = 0;  ///< error of the attitude against the closed form [rad], worst rate in the first turn (or
                          ///< step, if longer) times a turn; what is below 1e-14 does not count
  double attitude = 0;    ///< greatest error of the attitude over the run [rad]
};

Measured measure(const Method& method, const HardCase& hard_case);

/** The closed form asked for the same times; its attitude is compared with nothing here. */
Measured measureClosedForm(const HardCase& hard_case);

/** What must hold: bounds on what is measured, infinite where nothing is promised. */
struct Promise {
  double norm, momentum, energy, energy_outside, first_turn;
  bool must_be_finite;
};

/** Of a row of the table of methods, from its order and what it conserves, and of how its step was judged. */
Promise promiseOf(const Method& method, const HardCase& hard_case, const StepJudgement& judgement);

Promise promiseOfClosedForm(const HardCase& hard_case);

/** One sentence for each promise that is broken. */
std::vector<std::string> broken(const Promise& promise, const Measured& measured);

/** "" where a step that was called hopeless did indeed lose the motion, else what there was instead. */
std::string wronglyRefused(const StepJudgement& judgement, const Measured& measured);

}  // namespace poinsot
