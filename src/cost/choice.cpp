#include "poinsot/cost/choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "poinsot/core/no_convergence.h"
#include "poinsot/core/number_text.h"
#include "poinsot/core/rotation.h"
#include "poinsot/core/step_limits.h"
#include "poinsot/core/stepper.h"
#include "poinsot/cost/torque_choice.h"

namespace poinsot::cost {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kLeastVerified = 2 * kClosedFormError;  // [rad]: below it the judge is no more exact than the judged
constexpr double kAim = 0.8;                             // of the accuracy: what is looked for
constexpr double kGiveUp = 30;           // times the accuracy: how wrong a trial may become before it ends
constexpr double kMostSteps = 5e7;       // of one trial: some seconds
constexpr std::int64_t kLooks = 4096;    // of one trial
constexpr double kMostTicks = 1e6;       // to be verified one by one
constexpr double kNearEnough = 1.1;      // two steps with this ratio are not told apart
constexpr int kMostTrials = 20;          // to one method
constexpr int kMostWithoutProgress = 4;  // of them
constexpr int kMostCorrections = 6;      // after a verification that failed
constexpr double kLongestAngle = 2;      // rad: no step is tried that turns the body by more, unless it is a tick

/** How near a method came. */
struct Nearest {
  std::string method;
  double error = kInfinite;
  bool steps_ran_out = false;  ///< not rounding but the number of steps stood in the way
};

class Search {
 public:
  Search(const MotionSetup& setup, const AccuracyRequest& request, const MethodCosts& costs,
         const std::atomic<bool>& cancel)
      : setup_(setup),
        request_(request),
        costs_(costs),
        cancel_(cancel),
        start_(RotationState::fromOmega(setup.inertia.moments(), setup.attitude.normalized() * setup.inertia.axes(),
                                        setup.inertia.toPrincipal(setup.omega_body))),
        exact_(setup.inertia.moments(), start_.attitude, start_.omegaBody(setup.inertia.moments())) {
    const double fastest = orbitRates(setup.inertia.moments(), setup.inertia.toPrincipal(setup.omega_body)).fastest();
    longest_ =
        std::min(request.horizon, std::max(1 / request.rate, fastest > 0 ? kLongestAngle / fastest : request.horizon));
  }

  Choice run() {
    for (const std::string& name : request_.candidates) {
      if (name == kClosedForm) tryClosedForm();
    }
    // Higher orders first: what they cost rules most others out before these have taken a step.
    std::vector<const Method*> steppers;
    for (const std::string& name : request_.candidates) {
      if (const Method* method = findMethod(name)) steppers.push_back(method);
    }
    std::stable_sort(steppers.begin(), steppers.end(), [](const Method* a, const Method* b) {
      return std::pair(a->conserves_energy, a->order) > std::pair(b->conserves_energy, b->order);
    });
    if (request_.accuracy >= kLeastVerified) {
      for (const Method* method : steppers) tryStepper(*method);
    }
    if (best_.method.empty()) refuse();
    return best_;
  }

 private:
  struct Trial {
    double error;    ///< greatest so far [rad]
    double reached;  ///< when it was given up, or the horizon [s]
  };

  bool improves(double cost) const { return best_.method.empty() || cost < best_.cost; }

  double costOf(const Method& method, double step) const {
    return costs_.perSimulatedSecond(method.name, step, request_.rate);
  }

  void tryClosedForm() {
    if (request_.accuracy < kClosedFormError) {
      note(kClosedForm, kClosedFormError, false);
      return;
    }
    best_ = {kClosedForm, std::nullopt, kClosedFormError, kClosedFormError,
             costs_.perSimulatedSecond(kClosedForm, 0, request_.rate)};
  }

  void note(const std::string& method, double error, bool steps_ran_out) {
    if (error <= nearest_.error) nearest_ = {method, error, steps_ran_out};
  }

  /** Runs to the horizon, or until the error is far above the accuracy. */
  Trial walk(const Stepper& stepper, double step) const {
    const auto steps = static_cast<std::int64_t>(std::ceil(request_.horizon / step));
    const std::int64_t looks = std::min(steps, kLooks);
    RotationState state = start_;
    Trial trial{0, 0};
    std::int64_t n = 0;
    for (std::int64_t k = 1; k <= looks; ++k) {
      throwIf(cancel_);
      const auto next =
          static_cast<std::int64_t>(static_cast<double>(steps) * static_cast<double>(k) / static_cast<double>(looks));
      try {
        stepper.advance(state, step, next - n);
      } catch (const NoConvergence&) {
        return {kInfinite, trial.reached};
      }
      n = next;
      trial.reached = static_cast<double>(n) * step;
      const double error = angleBetween(state.attitude, exact_.at(trial.reached).attitude);
      if (!(error <= 4)) return {kInfinite, trial.reached};
      trial.error = std::max(trial.error, error);
      if (trial.error > kGiveUp * request_.accuracy) break;
    }
    return trial;
  }

  /** What the error would have become by the horizon, at least. */
  double extrapolated(const Trial& trial) const {
    return trial.error * std::max(1.0, request_.horizon / trial.reached);
  }

  /** The factor on a step that brings an error to the aim. */
  double correction(const Method& method, double error) const {
    return std::pow(kAim * request_.accuracy / error, 1.0 / method.order);
  }

  struct Found {
    double step = 0;  ///< 0: none
    double error = 0;
  };

  /** The longest step that keeps the accuracy and costs less than the best so far. */
  Found longestStep(const Method& method) {
    const auto stepper = method.make(setup_.inertia.moments());
    Found good;
    double bad = kInfinite, last_error = kInfinite, last_reached = 0, last_step = 0, step = longest_;
    int without_progress = 0;
    for (int i = 0; i < kMostTrials; ++i) {
      if (!improves(costOf(method, step))) break;
      if (request_.horizon / step > kMostSteps) {
        if (good.step == 0 && last_error < kInfinite) note(method.name, last_error, true);
        break;
      }
      const Trial trial = walk(*stepper, step);
      double next;
      if (trial.error <= request_.accuracy) {
        good = {step, trial.error};
        if (step >= longest_) break;
        next = step * std::min(4.0, correction(method, std::max(trial.error, 1e-3 * request_.accuracy)));
        if (bad < kInfinite) next = std::min(next, std::sqrt(good.step * bad));
        next = std::min(next, longest_);
        if (next < kNearEnough * good.step) break;
      } else {
        bad = std::min(bad, step);
        if (good.step > 0) {
          if (bad < kNearEnough * good.step) break;
          next = std::sqrt(good.step * bad);
        } else if (!(trial.error < 0.3)) {
          next = 0.5 * step;
        } else {
          const double error = extrapolated(trial);
          // Where shorter steps bring neither less error nor a later one, rounding is what is left.
          const bool better =
              error < 0.9 * last_error && (trial.reached >= request_.horizon || trial.reached > 1.02 * last_reached);
          if (step <= last_step / 1.4) without_progress = better ? 0 : without_progress + 1;
          note(method.name, error, false);
          if (without_progress == kMostWithoutProgress) break;
          last_error = error;
          last_reached = trial.reached;
          last_step = step;
          next = step * std::clamp(correction(method, error), 1e-3, 0.7);
        }
      }
      step = next;
    }
    return good;
  }

  /** Compares the motion as it will be asked for its states with the closed form. */
  double verified(const Method& method, double step) const {
    MotionSetup setup = setup_;
    setup.method = method.name;
    setup.step = step;
    Motion motion(setup);
    const double ticks = std::floor(request_.horizon * request_.rate), stride = std::max(1.0, ticks / kMostTicks);
    double worst = 0;
    const auto look = [&](double t) {
      prepare(motion, t, cancel_);
      const double error = motion.attitudeError(motion.at(t));
      worst = error <= worst ? worst : error;  // also where it is undefined
      return worst <= request_.accuracy;
    };
    for (double k = 1; k <= ticks; k += stride) {
      if (!look(std::floor(k) / request_.rate)) return worst;
    }
    look(request_.horizon);
    return worst;
  }

  void tryStepper(const Method& method) {
    if (!improves(costOf(method, kInfinite))) return;
    Found found = longestStep(method);
    for (int i = 0; found.step > 0 && i < kMostCorrections; ++i) {
      const double cost = costOf(method, found.step);
      if (!improves(cost)) return;
      double error = kInfinite;
      try {
        error = verified(method, found.step);
      } catch (const std::runtime_error&) {  // range_error, NoConvergence: worse than any error
      }
      if (error <= request_.accuracy - kClosedFormError) {
        best_ = {method.name, found.step, found.error, error, cost};
        return;
      }
      note(method.name, error, false);
      found.step *= std::clamp(correction(method, error), 0.3, 0.95);
    }
  }

  [[noreturn]] void refuse() const {
    std::string why = "no method of " + std::to_string(request_.candidates.size()) + " allowed ones";
    if (request_.candidates.size() == 1) why = request_.candidates.front();
    why += request_.candidates.size() == 1 ? " does not keep to " : " keeps to ";
    why += numberText(request_.accuracy, 3) + " rad for " + numberText(request_.horizon, 3) + " s on this body";
    if (request_.accuracy < kClosedFormError) {
      why += ": nothing is verified beyond the " + numberText(kClosedFormError, 3) +
             " rad to which the closed form is known";
    } else if (request_.accuracy < kLeastVerified && nearest_.error == kInfinite) {
      why += ": steppers are verified by the closed form, which is known to " + numberText(kClosedFormError, 3) +
             " rad itself";
    } else if (!(nearest_.error < 0.1)) {
      why += ", nor comes near";
      if (nearest_.steps_ran_out) why += " within " + numberText(kMostSteps, 3) + " steps";
    } else {
      why += ": " + nearest_.method + " comes nearest with about " + numberText(nearest_.error, 3) + " rad, and then " +
             (nearest_.steps_ran_out ? "takes more than " + numberText(kMostSteps, 3) + " steps to be tried"
                                     : "rounding is in the way");
    }
    throw Unreachable(why);
  }

  MotionSetup setup_;
  AccuracyRequest request_;
  const MethodCosts& costs_;
  const std::atomic<bool>& cancel_;
  RotationState start_;
  ClosedForm exact_;
  double longest_;  ///< step to begin with [s]
  Choice best_;
  Nearest nearest_;
};

}  // namespace

Choice choose(const MotionSetup& setup, const AccuracyRequest& request, const MethodCosts& costs,
              const std::atomic<bool>& cancel) {
  if (!setup.effects.empty()) return chooseUnderTorques(setup, request, costs, cancel);
  return Search(setup, request, costs, cancel).run();
}

}  // namespace poinsot::cost
