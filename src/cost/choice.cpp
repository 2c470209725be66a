#include "poinsot/cost/choice.h"
#include "poinsot/core/method.h"

#include <algorithm>
#include <cmath>

#include "poinsot/core/number_text.h"
#include "truth.h"

namespace poinsot::cost {
namespace {

constexpr double kNearEnough = 1.1;      // two steps with this ratio are not told apart
constexpr int kMostTrials = 24;          // to one method
constexpr int kMostWithoutProgress = 4;  // of them
constexpr int kMostCorrections = 6;      // after a verification that failed
constexpr double kMostStepsAtAll = 1e9;  // of a motion that is not verified

/** What kept a method from a smaller error, as far as that was found. */
enum class Limit { none, steps, rounding };

/** The method with the smallest error, among those that miss the accuracy. */
struct Nearest {
  std::string method;
  double error = kInfinite;
  Limit limit = Limit::none;
};

/** The search for the cheapest method and step. */
class Search {
 public:
  Search(const AccuracyRequest& request, const MethodCosts& costs, bool torqued, const Truth& truth)
      : request_(request), costs_(costs), torqued_(torqued), truth_(truth) {}

  Choice run() {
    const std::string objection = truth_.objection();
    std::vector<const Method*> steppers;
    for (const std::string& name : request_.candidates) {
      if (name == kClosedForm && !torqued_) tryClosedForm();
      if (const Method* method = findMethod(name, torqued_ ? torquedMethods() : freeMethods()))
        steppers.push_back(method);
    }
    if (objection.empty()) {
      limits_ = truth_.limits();
      // Higher orders come first: their cost rules out most others before these have taken a step.
      std::stable_sort(steppers.begin(), steppers.end(), [](const Method* a, const Method* b) {
        return std::pair(a->conserves_energy, a->order) > std::pair(b->conserves_energy, b->order);
      });
      for (const Method* method : steppers) tryStepper(*method);
    }
    if (best_.method.empty()) throw Unreachable(objection.empty() ? nobodyKeepsTo() : cannotBeVerified() + objection);
    return best_;
  }

 private:
  bool improves(double cost) const { return best_.method.empty() || cost < best_.cost; }

  double costOf(const Method& method, double step) const {
    return costs_.perSimulatedSecond(costName(method.name, torqued_), step, request_.rate);
  }

  void tryClosedForm() {
    if (request_.accuracy < kClosedFormError) return;
    best_ = {kClosedForm, std::nullopt, kClosedFormError, kClosedFormError,
             costs_.perSimulatedSecond(kClosedForm, 0, request_.rate)};
  }

  void note(const Method& method, double error, Limit limit = Limit::none) {
    if (error <= nearest_.error) nearest_ = {method.name, error, limit};
  }

  /** Returns a lower bound of the error that the trial would have had at the horizon. */
  double extrapolated(const Trial& trial) const {
    return trial.error * std::max(1.0, request_.horizon / trial.reached);
  }

  /** Returns the factor by which a step must change for the error to reach the aim. */
  double correction(const Method& method, double error) const {
    return std::pow(limits_.aim * request_.accuracy / error, 1.0 / method.order);
  }

  struct Found {
    double step = 0;  ///< 0: none
    Trial trial;
  };

  /** Returns the longest step that keeps the accuracy and costs less than the best so far. */
  Found longestStep(const Method& method) {
    Found good;
    double bad = kInfinite, last_error = kInfinite, last_reached = 0, step = limits_.first;
    int without_progress = 0;
    for (int i = 0; i < kMostTrials && improves(costOf(method, step)); ++i) {
      if (request_.horizon / step > limits_.most_steps) {
        if (good.step == 0 && last_error < kInfinite) note(method, last_error, Limit::steps);
        break;
      }
      const Trial trial = truth_.run(method, step);
      const bool keeps = trial.error <= limits_.kept * request_.accuracy;
      if (keeps && !trial.cut) {
        good = {step, trial};
        if (step >= limits_.longest) break;
        step *= std::min(4.0, correction(method, std::max(trial.error, 1e-3 * request_.accuracy)));
        if (bad < kInfinite) step = std::min(step, std::sqrt(good.step * bad));
        step = std::min(step, limits_.longest);
        if (step < kNearEnough * good.step) break;
        continue;
      }
      bad = std::min(bad, step);
      if (good.step > 0) {
        if (bad < kNearEnough * good.step) break;
        step = std::sqrt(good.step * bad);
      } else if (!(trial.error < 0.3) || keeps) {
        step *= 0.5;
      } else {
        const double error = extrapolated(trial);
        // Where shorter steps neither reduce the error nor delay it, rounding is the limit.
        const bool better =
            error < 0.9 * last_error && (trial.reached >= request_.horizon || trial.reached > 1.02 * last_reached);
        without_progress = better ? 0 : without_progress + 1;
        note(method, error);
        if (without_progress == kMostWithoutProgress) {
          if (nearest_.method == method.name) nearest_.limit = Limit::rounding;
          break;
        }
        last_error = error;
        last_reached = trial.reached;
        step *= std::clamp(correction(method, error), 1e-3, 0.7);
      }
    }
    return good;
  }

  void tryStepper(const Method& method) {
    if (!improves(costOf(method, kInfinite))) return;
    Found found = longestStep(method);
    for (int i = 0; found.step > 0 && i < kMostCorrections; ++i) {
      const double cost = costOf(method, found.step);
      if (!improves(cost)) return;
      const double error = truth_.verified(method, found.step, found.trial);
      if (error <= request_.accuracy) {
        best_ = {method.name, found.step, found.trial.error, error, cost};
        return;
      }
      note(method, error);
      found.step *= std::clamp(correction(method, error), 0.3, 0.95);
    }
  }

  std::string cannotBeVerified() const {
    return request_.candidates.size() == 1 ? request_.candidates.front() + " cannot be verified: " : std::string();
  }

  std::string nobodyKeepsTo() const {
    const std::size_t count = request_.candidates.size();
    const std::string steps = numberText(limits_.most_steps, 3) + " steps";
    std::string out = count == 1 ? request_.candidates.front() + " does not keep to "
                                 : "none of the " + std::to_string(count) + " candidates keeps to ";
    out += numberText(request_.accuracy, 3) + " rad for " + numberText(request_.horizon, 3) + " s on this body";
    if (!(nearest_.error < 0.1)) {
      return out + (count == 1 ? ", nor does it come near" : ", and none comes near") +
             (nearest_.limit == Limit::steps ? " within " + steps : "");
    }
    out += ": " + nearest_.method + " comes nearest with about " + numberText(nearest_.error, 3) + " rad";
    if (nearest_.limit == Limit::steps) out += "; with shorter steps it would take more than " + steps;
    if (nearest_.limit == Limit::rounding) out += "; rounding prevents a smaller error";
    return out;
  }

  const AccuracyRequest& request_;
  const MethodCosts& costs_;
  bool torqued_;
  const Truth& truth_;
  Truth::Limits limits_ = {};
  Choice best_;
  Nearest nearest_;
};

}  // namespace

Choice choose(const MotionSetup& setup, const AccuracyRequest& request, const MethodCosts& costs,
              const std::atomic<bool>& cancel) {
  const bool torqued = !setup.effects.empty();
  const std::unique_ptr<Truth> truth =
      torqued ? refinedTruth(setup, request, cancel) : closedFormTruth(setup, request, cancel);
  return Search(request, costs, torqued, *truth).run();
}

Choice mostExact(const MotionSetup& setup, const AccuracyRequest& request, const MethodCosts& costs,
                 const std::atomic<bool>& cancel) {
  const std::unique_ptr<RefinedTruth> truth = refinedTruth(setup, request, cancel);
  if (!(truth->step() > 0) || request.horizon / truth->step() > kMostStepsAtAll) {
    throw Unreachable("this body moves so fast under its effects that " + numberText(request.horizon, 3) +
                      " s of it take more than " + numberText(kMostStepsAtAll, 3) + " steps");
  }
  const double cost = costs.perSimulatedSecond(costName(truth->method(), true), truth->step(), request.rate);
  return {truth->method(), truth->step(), truth->agreement(), truth->agreement(), cost};
}

}  // namespace poinsot::cost
