#pragma once

#include <atomic>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "poinsot/core/motion.h"
#include "poinsot/cost/cancelled.h"
#include "poinsot/cost/method_costs.h"

/** The cheapest way to an accuracy. */
namespace poinsot::cost {

struct AccuracyRequest {
  double accuracy = 0;                  ///< attitude error that may be reached [rad], positive
  double horizon = 0;                   ///< it must hold for 0 ≤ t ≤ horizon [s], positive
  double rate = 0;                      ///< at which the state will be asked for [Hz], positive
  std::vector<std::string> candidates;  ///< methods to choose from, "closed_form" among them or not
};

struct Choice {
  std::string method;
  std::optional<double> step;  ///< [s]; none for the closed form
  double estimated_error = 0;  ///< at the ends of steps, while the step was looked for [rad]
  double verified_error = 0;   ///< the greatest at the ticks, up to a million of them, and at the horizon [rad]
  double cost = 0;             ///< CPU seconds per simulated second, by the costs given
};

/** No candidate reaches the accuracy: what() says which came nearest and how near, and what is allowed instead. */
class Unreachable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/** What the closed form is held to by references of 60 digits: an accuracy below it is out of reach [rad]. */
constexpr double kClosedFormError = 2e-15;

/**
 * Chooses the cheapest candidate and step. Of a body with effects: torque_choice.h. Of a free one: for each method the
 * longest step that keeps the accuracy is found by trial over the whole horizon, from the order of the method; then the
 * motion itself is compared with the closed form at its ticks. Methods that cannot become cheaper than the best so far
 * are left out.
 *
 * @param setup the body and its start; method and step in it are not looked at.
 * @param cancel makes it give up within some 10 ms.
 * Takes about as long as a few runs to the horizon, milliseconds for most. Throws Unreachable, or Cancelled.
 */
Choice choose(const MotionSetup& setup, const AccuracyRequest& request, const MethodCosts& costs,
              const std::atomic<bool>& cancel = kNeverCancelled);

}  // namespace poinsot::cost
