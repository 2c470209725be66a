#include <algorithm>
#include <cmath>

#include "poinsot/core/no_convergence.h"
#include "poinsot/core/number_text.h"
#include "poinsot/core/rotation.h"
#include "poinsot/core/step_limits.h"
#include "truth.h"

namespace poinsot::cost {
namespace {

constexpr double kLeastVerified =
    2 * kClosedFormError;              // rad: below it the closed form is no more exact than the stepper
constexpr double kGiveUp = 30;         // times the accuracy: a trial with a larger error is given up
constexpr double kMostSteps = 5e7;     // of one trial: some seconds
constexpr std::int64_t kLooks = 4096;  // of one trial
constexpr double kMostTicks = 1e6;     // to be verified one by one
constexpr double kLongestAngle = 2;    // rad: no step is tried that turns the body by more, unless it is a tick

class ClosedFormTruth final : public Truth {
 public:
  ClosedFormTruth(const MotionSetup& setup, const AccuracyRequest& request, const std::atomic<bool>& cancel)
      : setup_(setup),
        request_(request),
        cancel_(cancel),
        start_(RotationState::fromOmega(setup.inertia.moments(), setup.attitude.normalized() * setup.inertia.axes(),
                                        setup.inertia.toPrincipal(setup.omega_body))),
        exact_(setup.inertia.moments(), start_.attitude, start_.omegaPrincipal(setup.inertia.moments())) {}

  std::string objection() const override {
    const std::string known = numberText(kClosedFormError, 3) + " rad";
    if (request_.accuracy < kClosedFormError) {
      return "the closed form, by which accuracies are verified, is itself known to " + known + " only";
    }
    if (request_.accuracy < kLeastVerified) {
      return "the closed form, by which steppers are verified, is itself known to " + known + " only";
    }
    return "";
  }

  Limits limits() const override {
    const double fastest =
        orbitRates(setup_.inertia.moments(), setup_.inertia.toPrincipal(setup_.omega_body)).fastest();
    const double by_angle = fastest > 0 ? kLongestAngle / fastest : request_.horizon;
    const double longest = std::min(request_.horizon, std::max(1 / request_.rate, by_angle));
    return {longest, longest, kMostSteps, 0.8, 1};
  }

  Trial run(const Method& method, double step) const override {
    const std::unique_ptr<Stepper> stepper = method.make(setup_.inertia.moments());
    const auto steps = static_cast<std::int64_t>(std::ceil(request_.horizon / step));
    const std::int64_t looks = std::min(steps, kLooks);
    RotationState state = start_;
    Trial trial;
    std::int64_t n = 0;
    for (std::int64_t k = 1; k <= looks; ++k) {
      throwIf(cancel_);
      const auto next =
          static_cast<std::int64_t>(static_cast<double>(steps) * static_cast<double>(k) / static_cast<double>(looks));
      try {
        stepper->advance(state, n, step, next - n);
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

  /** Compares with the closed form at the ticks, up to a million of them, and at the horizon. */
  double verified(const Method& method, double step, const Trial&) const override {
    MotionSetup setup = setup_;
    setup.method = method.name;
    setup.step = step;
    Motion motion(setup);
    const double ticks = std::floor(request_.horizon * request_.rate), stride = std::max(1.0, ticks / kMostTicks);
    double worst = 0;
    const auto look = [&](double t) {
      prepare(motion, t, cancel_);
      const double error = motion.attitudeError(motion.at(t)) + kClosedFormError;
      worst = error <= worst ? worst : error;  // also where it is undefined
      return worst <= request_.accuracy;
    };
    try {
      for (double k = 1; k <= ticks; k += stride) {
        if (!look(std::floor(k) / request_.rate)) return worst;
      }
      look(request_.horizon);
    } catch (const std::runtime_error&) {  // range_error, NoConvergence: worse than any error
      return kInfinite;
    }
    return worst;
  }

 private:
  MotionSetup setup_;
  AccuracyRequest request_;
  const std::atomic<bool>& cancel_;
  RotationState start_;
  ClosedForm exact_;
};

}  // namespace

std::unique_ptr<Truth> closedFormTruth(const MotionSetup& setup, const AccuracyRequest& request,
                                       const std::atomic<bool>& cancel) {
  return std::make_unique<ClosedFormTruth>(setup, request, cancel);
}

}  // namespace poinsot::cost
