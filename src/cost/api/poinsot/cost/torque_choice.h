#pragma once

#include <atomic>

#include "poinsot/cost/cancelled.h"
#include "poinsot/cost/choice.h"

namespace poinsot::cost {

/**
 * choose() for a body under torques. There is no closed form: the truth is the motion itself by a Taylor method of high
 * order, at a step that is halved until another order at another step gives the same to a tenth of the accuracy. The
 * accuracy is that of the attitude [rad] and, relative to |Ω|, of Ω (but for moments at which |Ω| is below a hundredth
 * of its greatest, and for a body brought to rest, of whose spin rounding leaves 1e-14), at up to 512 times up to the
 * horizon, that included.
 *
 * Throws Unreachable, also where the two do not come to agree: rounding, or a motion so sensitive that doubles do not
 * tell.
 */
Choice chooseUnderTorques(const MotionSetup& setup, const AccuracyRequest& request, const MethodCosts& costs,
                          const std::atomic<bool>& cancel = kNeverCancelled);

/** The motion as exactly as doubles have it, whatever that is; verified_error says how far the two came to agree. */
Choice mostExactUnderTorques(const MotionSetup& setup, const AccuracyRequest& request, const MethodCosts& costs,
                             const std::atomic<bool>& cancel = kNeverCancelled);

/** As methods that take torques are called in MethodCosts: the names of some stand for another way without them. */
inline std::string torqueCostName(const std::string& method) {
  return "torques/" + method;
}

}  // namespace poinsot::cost
