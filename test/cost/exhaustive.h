#pragma once

#include <optional>
#include <string>
#include <vector>

#include "poinsot/core/motion.h"

/** What a choice of method and step is measured by: every method, one step after the other. */
namespace poinsot::exhaustive {

/** Free bodies of all kinds: moments of a real body, |Ω| from 0.1 to 10 rad/s, principal axes turned at random. */
std::vector<MotionSetup> randomBodies(int count, unsigned seed);

/**
 * The greatest attitude error [rad] against the closed form at `times`, ascending, or infinity where the motion has no
 * state; stops at the first that exceeds `enough`.
 */
double errorAt(const MotionSetup& setup, const std::vector<double>& times, double enough);

/** Times drawn evenly from (0, horizon), ascending, and the horizon: no ticks. */
std::vector<double> randomTimes(double horizon, int count, unsigned seed);

struct Way {
  std::string method;
  double step;
};

/**
 * Of each method the longest step of a ladder that keeps the accuracy: steps fall by a tenth from two radians or a
 * tick. A method stops where `least_cost(method, step)` shows that it has become dearer than `most`.
 */
std::vector<Way> waysToKeep(const MotionSetup& setup, double accuracy, double horizon, double rate,
                            double (*least_cost)(const std::string& method, double step, double rate), double most);

}  // namespace poinsot::exhaustive
