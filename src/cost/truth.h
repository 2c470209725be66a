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

/** A method at a step, run towards the horizon. */
struct Trial {
  double error = 0;    ///< greatest so far [rad]; infinite where the motion was lost
  double reached = 0;  ///< the horizon, or when the trial was given up [s]
  bool cut = false;    ///< many steps were taken in parts: shorter ones are cheaper
};

/** What the steps of one body are judged by: its true motion up to the horizon of a request. */
class Truth {
 public:
  virtual ~Truth() = default;

  /** Why no stepper can be verified to the accuracy; empty where one can. */
  virtual std::string objection() const = 0;

  /** The limits of a search. */
  struct Limits {
    double first;       ///< step to begin with [s]
    double longest;     ///< step [s]
    double most_steps;  ///< of one trial: some seconds
    double aim;         ///< share of the accuracy that is looked for
    double kept;        ///< share of the accuracy that a trial may reach, for times between its looks
  };
  /** Of use where there is no objection. */
  virtual Limits limits() const = 0;

  /** Goes on until the horizon, or until the error is far above the accuracy. */
  virtual Trial run(const Method& method, double step) const = 0;

  /** The greatest error [rad] of the motion as it will be asked for its states, that of the truth itself included. */
  virtual double verified(const Method& method, double step, const Trial& trial) const = 0;
};

/** The closed form, for a free body. */
std::unique_ptr<Truth> closedFormTruth(const MotionSetup& setup, const AccuracyRequest& request,
                                       const std::atomic<bool>& cancel);

/**
 * For a body under torques: the motion by a Taylor method of high order, at a step that is halved until another order
 * at another step gives the same to a tenth of the accuracy.
 */
class RefinedTruth : public Truth {
 public:
  /** The best that doubles have: a method and step, and how far two such came to agree [rad]; infinite: not known. */
  virtual const char* method() const = 0;
  virtual double step() const = 0;
  virtual double agreement() const = 0;
};
std::unique_ptr<RefinedTruth> refinedTruth(const MotionSetup& setup, const AccuracyRequest& request,
                                           const std::atomic<bool>& cancel);

}  // namespace poinsot::cost
