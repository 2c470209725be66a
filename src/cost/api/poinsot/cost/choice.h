#pragma once

#include <atomic>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "poinsot/core/motion.h"
#include "poinsot/cost/cancelled.h"
#include "poinsot/cost/method_costs.h"

/** The choice of the cheapest method and step for an accuracy. */
namespace poinsot::cost {

struct AccuracyRequest {
  double accuracy = 0;                  ///< greatest attitude error [rad], positive
  double horizon = 0;                   ///< it must hold for 0 ≤ t ≤ horizon [s], positive
  double rate = 0;                      ///< at which the state will be asked for [Hz], positive
  std::vector<std::string> candidates;  ///< methods to choose from, "closed_form" among them or not
};

struct Choice {
  std::string method;
  std::optional<double> step;  ///< [s]; none for the closed form
  double estimated_error = 0;  ///< at the ends of steps, during the search [rad]
  double verified_error = 0;   ///< of a free body the greatest at the ticks, up to a million of them, and at the
                               ///< horizon [rad]; under torques the estimated one, which is that at up to 512 times
  double cost = 0;             ///< CPU seconds per simulated second, by the given costs
};

/** No candidate reaches the accuracy; what() says which comes nearest, and how near. */
class Unreachable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/** The bound of the closed form's error, by references of 60 digits: a smaller accuracy is out of reach [rad]. */
constexpr double kClosedFormError = 2e-15;

/**
 * Returns the cheapest candidate and step. The longest step of each method that keeps the accuracy is found by trials
 * over the whole horizon, guided by the order of the method. Methods that cannot be cheaper than the best so far are
 * left out.
 *
 * A free body is compared with the closed form: in trials at the ends of steps, and then at the times of its states.
 * Under torques the truth is the motion itself by a Taylor method of high order, at a step that is halved until another
 * order at another step gives the same to a tenth of the accuracy. The accuracy is then that of the attitude [rad] and,
 * relative to |Ω|, of Ω (but for moments at which |Ω| is below a hundredth of its greatest, and for a body brought to
 * rest, of whose spin rounding leaves 1e-14), at up to 512 times up to the horizon, that included.
 *
 * Takes about as long as a few runs to the horizon, milliseconds for most. Throws Cancelled, and Unreachable, under
 * torques also where the truth is not known to the accuracy because of rounding or a very sensitive motion.
 * @param setup the body and its start; its method and step are ignored.
 * @param cancel makes it give up within some 10 ms.
 */
Choice choose(const MotionSetup& setup, const AccuracyRequest& request, const MethodCosts& costs,
              const std::atomic<bool>& cancel = kNeverCancelled);

/**
 * Returns the most exact choice for a motion under torques; verified_error is the difference of two references. Throws
 * like choose().
 */
Choice mostExact(const MotionSetup& setup, const AccuracyRequest& request, const MethodCosts& costs,
                 const std::atomic<bool>& cancel = kNeverCancelled);

}  // namespace poinsot::cost
