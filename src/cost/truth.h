#pragma once

#include <atomic>
#include <limits>
#include <memory>
#include <string>

#include "poinsot/core/method.h"
#include "poinsot/core/motion.h"
#include "poinsot/cost/choice.h"

namespace poinsot::cost {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/** The result of a method at a step, run towards the horizon. */
struct Trial {
  double error = 0;    ///< greatest so far [rad]; infinite where the motion was lost
  double reached = 0;  ///< the horizon, or the time at which the trial was given up [s]
  bool cut = false;    ///< many steps were taken in parts, so that shorter ones are cheaper
};

/** The true motion of a body up to the horizon of a request, by which steps are judged. */
class Truth {
 public:
  virtual ~Truth() = default;

  /** Returns the reason why no stepper can be verified to the accuracy; empty where one can. */
  virtual std::string objection() const = 0;

  /** The limits of a search. */
  struct Limits {
    double first;       ///< step to begin with [s]
    double longest;     ///< step [s]
    double most_steps;  ///< of one trial: some seconds
    double aim;         ///< error to aim at, as a share of the accuracy
    double kept;        ///< largest error of a trial, as a share of the accuracy; the rest is for times between looks
  };
  /** Returns the limits; call it only where there is no objection. */
  virtual Limits limits() const = 0;

  /** Runs the method to the horizon, or until the error is far above the accuracy. */
  virtual Trial run(const Method& method, double step) const = 0;

  /**
   * Returns the greatest error [rad], that of the truth included: of a free body at the times at which states will be
   * asked for; under torques the error of the trial, whose looks are as dense as is worthwhile.
   */
  virtual double verified(const Method& method, double step, const Trial& trial) const = 0;
};

/** Returns the closed form, for a free body. */
std::unique_ptr<Truth> closedFormTruth(const MotionSetup& setup, const AccuracyRequest& request,
                                       const std::atomic<bool>& cancel);

/**
 * The truth of a body under torques: the motion by a Taylor method of high order, at a step that is halved until
 * another order at another step gives the same to a tenth of the accuracy.
 */
class RefinedTruth : public Truth {
 public:
  /** Returns the most exact method. */
  virtual const char* method() const = 0;
  /** Returns its step [s]. */
  virtual double step() const = 0;
  /** Returns the difference of two such references [rad]; infinite where it is not known. */
  virtual double agreement() const = 0;
};
std::unique_ptr<RefinedTruth> refinedTruth(const MotionSetup& setup, const AccuracyRequest& request,
                                           const std::atomic<bool>& cancel);

}  // namespace poinsot::cost
