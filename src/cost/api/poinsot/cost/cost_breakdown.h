#pragma once

#include <string>
#include <vector>

#include "poinsot/core/motion.h"

namespace poinsot::cost {

/**
 * What one body's motion costs on this machine, and who causes it: CPU time, measured, the fastest of several runs with
 * warm caches.
 *
 * An effect's part is what the motion costs with it less what it costs without, by the same method and step, from the
 * same states: stretches of the motion as the scene has it, spread over its first steps. Where several act, it is the
 * mean over two orders of putting them in, the first type first and the last type first, so that the parts add up and
 * none pays alone for what they share. A part may come out a little below 0: the noise of a difference.
 */
struct CostBreakdown {
  struct Part {
    std::string name;      ///< "free_motion", or the effect's type
    bool in_force;         ///< absent effects have cost exactly 0
    double per_step = 0;   ///< of a whole step [s]
    double per_state = 0;  ///< of a state that is asked for, its partial step included [s]
  };

  /** Free motion under the body's method, then every type of effect there is, in the order of effectTypes(). */
  std::vector<Part> parts;
  double steps = 0;               ///< whole steps in a simulated second; 0 in closed form
  double states = 0;              ///< in a simulated second
  double torque_evaluations = 0;  ///< in a simulated second, of whole steps, partial steps and states
  double run = 0;                 ///< all of it run through once, as simulate does [CPU s per simulated s]

  double perStep() const;
  double perState() const;
  /** [CPU s per simulated s] */
  double perSecond(const Part& part) const { return steps * part.per_step + states * part.per_state; }
  /** The sum over the parts, to be compared with run. */
  double perSecond() const { return steps * perStep() + states * perState(); }
};

/** "translation", "constant_torque", …: all types that a scene may name. */
const std::vector<std::string>& effectTypes();

/**
 * Measures for some 10 ms to a second, or as long as a run over the duration takes.
 * @param duration how long to simulate [s] and @param rate states in a simulated second [Hz], positive and finite.
 * Throws what Motion throws.
 */
CostBreakdown measureLedger(const MotionSetup& setup, double duration, double rate);

}  // namespace poinsot::cost
