#pragma once

#include <string>
#include <vector>

#include "poinsot/core/motion.h"

namespace poinsot::cost {

/**
 * The CPU time of one body's motion on this machine, and the share of each effect: the fastest of several runs with
 * warm caches.
 *
 * An effect's part is the cost of the motion with it less the cost without it, under the same method and step, from the
 * same states: stretches of the scene's motion, spread over its first steps. Where several effects act, it is the mean
 * over two orders of adding them, the first type first and the last type first, so that the parts add up and shared
 * cost is shared. A part may be slightly below 0, because it is a difference of noisy figures.
 */
struct CostBreakdown {
  struct Part {
    std::string name;      ///< "free_motion", or the effect's type
    bool in_force;         ///< the cost of an absent effect is exactly 0
    double per_step = 0;   ///< for a whole step [s]
    double per_state = 0;  ///< for a state, its partial step included [s]
  };

  /** Free motion under the body's method, then every type of effect, in the order of effectTypes(). */
  std::vector<Part> parts;
  double steps = 0;               ///< whole steps in a simulated second; 0 in closed form
  double states = 0;              ///< in a simulated second
  double torque_evaluations = 0;  ///< in a simulated second, of whole steps, partial steps and states
  double run = 0;                 ///< of a whole run, as by simulate [CPU s per simulated s]

  double perStep() const;
  double perState() const;
  /** Returns the cost of a part [CPU s per simulated s]. */
  double perSecond(const Part& part) const { return steps * part.per_step + states * part.per_state; }
  /** Returns the sum over the parts, to be compared with run. */
  double perSecond() const { return steps * perStep() + states * perState(); }
};

/** Returns all types that a scene may name: "translation", "constant_torque", … */
const std::vector<std::string>& effectTypes();

/**
 * Returns the breakdown, measured for some 10 ms to a second, or as long as a run over the duration takes. Throws what
 * Motion throws.
 * @param duration how long to simulate [s], and @param rate states in a simulated second [Hz], positive and finite.
 */
CostBreakdown measureCosts(const MotionSetup& setup, double duration, double rate);

}  // namespace poinsot::cost
