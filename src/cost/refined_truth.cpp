#include <algorithm>
#include <cmath>
#include <vector>

#include "poinsot/core/method.h"
#include "poinsot/core/number_text.h"
#include "poinsot/core/rotation.h"
#include "truth.h"

namespace poinsot::cost {
namespace {

constexpr double kAgree = 0.1;         // of the accuracy: how far two references should differ at most
constexpr double kAgreeAtWorst = 0.4;  // the same where rounding prevents a better agreement
constexpr double kSlow = 0.01;         // of the greatest |Omega|
constexpr double kRest = 1e-14;        // of the same: the rest that rounding leaves of a spin that has ended
constexpr int kMostLooks = 512;
constexpr int kMostRefinements = 24;
constexpr double kMostSteps = 2e7;  // of one trial: some seconds
constexpr double kMostCut = 1.02;   // steps taken to steps asked for: beyond it they are cut too often
const char* const kReferences[2] = {"taylor24", "taylor20"};
constexpr double kReferenceRatio = 0.77;  // of their steps: no common grid

/**
 * Returns an estimate of the fastest rate to come [1/s], from the start and the strength of the torques. Their strength
 * counts because a torque may be zero at the start and grow later (an upright pendulum, a thruster that waits).
 */
double rateAtStart(const Torques& torques, const Eigen::Vector3d& omega_body, double horizon) {
  const Eigen::Vector3d& moments = torques.moments();
  double strongest = 0;
  for (std::size_t k = 0; k <= torques.switches().size(); ++k) {
    const bool matters = (k == 0 || torques.switches()[k - 1] < horizon) &&
                         (k == torques.switches().size() || torques.switches()[k] > 0);
    if (!matters) continue;
    const Torques::Constant& constant = torques.constant(k);
    strongest =
        std::max(strongest, constant.body.cwiseQuotient(moments).norm() + constant.world.norm() / moments.minCoeff());
  }
  for (const Torques::Field& field : torques.fields()) {
    strongest += (moments.cwiseInverse().asDiagonal() * field.map).norm() * field.world.norm();
  }
  double rate = omega_body.norm() + std::sqrt(strongest);
  if (torques.gradient()) rate += torques.gradient()->rate;
  if (torques.damping()) rate += torques.damping()->norm() / moments.minCoeff();
  if (torques.slug()) rate += torques.slug()->damping * (1 / torques.slug()->inertia + 1 / moments.minCoeff());
  return rate;
}

class TaylorTruth final : public RefinedTruth {
 public:
  TaylorTruth(const MotionSetup& setup, const AccuracyRequest& request, const std::atomic<bool>& cancel)
      : setup_(setup), request_(request), cancel_(cancel), torques_(sumOf(setup.inertia, setup.effects)) {
    const double ticks = std::ceil(request.horizon * request.rate);
    const int looks = static_cast<int>(std::clamp(ticks, 16.0, double{kMostLooks}));
    for (int k = 1; k <= looks; ++k) times_.push_back(request.horizon * k / looks);
    refine();
  }

  const char* method() const override { return kReferences[0]; }
  double step() const override { return step_; }
  double agreement() const override { return agreement_; }

  std::string objection() const override {
    const std::string horizon = numberText(request_.horizon, 3) + " s";
    const std::string so = ", so that " + numberText(request_.accuracy, 3) + " rad cannot be verified";
    if (looks_.empty()) {
      return "a reference would take more than " + numberText(kMostSteps, 3) + " steps for " + horizon +
             ", or loses the motion" + so;
    }
    if (!(agreement_ <= kAgreeAtWorst * request_.accuracy)) {
      return "two references differ by " + numberText(agreement_, 3) + " rad within " + horizon +
             " (rounding, or a very sensitive motion)" + so;
    }
    return "";
  }

  Limits limits() const override {
    return {std::min(request_.horizon, 4 * step_), request_.horizon, kMostSteps, 0.5, 0.8};
  }

  Trial run(const Method& method, double step) const override {
    double cut = 1;
    Trial trial;
    trial.error = difference(looksOf(method, step, cut), looks_) + agreement_;
    trial.reached = request_.horizon;
    trial.cut = cut > kMostCut;
    return trial;
  }

  double verified(const Method&, double, const Trial& trial) const override { return trial.error; }

 private:
  struct Look {
    Eigen::Quaterniond attitude;
    Eigen::Vector3d omega;
  };

  /** Returns the motion at all looks, or at fewer where it was lost. @param cut gets steps taken per step asked for. */
  std::vector<Look> looksOf(const Method& method, double step, double& cut) const {
    std::vector<Look> out;
    MotionSetup setup = setup_;
    setup.method = method.name;
    setup.step = step;
    Motion motion(setup);
    try {
      for (const double t : times_) {
        prepare(motion, t, cancel_);
        const MotionState state = motion.at(t);
        out.push_back({state.attitude, state.omega_body});
      }
    } catch (const std::runtime_error&) {  // range_error, NoConvergence
    }
    const double steps = std::floor(request_.horizon / step) + static_cast<double>(torques_.switches().size());
    if (method.cuts_steps) cut = static_cast<double>(motion.work().evaluations) / (method.order * std::max(steps, 1.0));
    return out;
  }

  /** Returns the greatest difference; infinite where one of them ends early. */
  double difference(const std::vector<Look>& a, const std::vector<Look>& b) const {
    if (a.size() != times_.size() || b.size() != times_.size()) return kInfinite;
    double fastest = 0, worst = 0;
    for (const Look& look : b) fastest = std::max(fastest, look.omega.norm());
    for (std::size_t k = 0; k < a.size(); ++k) {
      // At the horizon the error of Ω is relative to Ω there, however slow.
      const double scale = k + 1 == a.size() ? b[k].omega.norm() : std::max(b[k].omega.norm(), kSlow * fastest);
      const bool rests = std::max(a[k].omega.norm(), b[k].omega.norm()) <= kRest * fastest;
      const double off = rests ? 0 : (a[k].omega - b[k].omega).norm();
      worst = std::max({worst, angleBetween(a[k].attitude, b[k].attitude), off > 0 ? off / scale : 0.0});
    }
    return worst;
  }

  void refine() {
    const double rate = rateAtStart(torques_, setup_.omega_body, request_.horizon);
    double step = rate > 0 ? std::min(request_.horizon, 1 / rate) : request_.horizon, cut = 1;
    step_ = step;
    int without_progress = 0;
    for (int i = 0; i < kMostRefinements && without_progress < 3; ++i, step *= 0.5) {
      if (request_.horizon / (kReferenceRatio * step) > kMostSteps) return;
      std::vector<Look> one = looksOf(*findMethod(kReferences[0]), step, cut);
      const std::vector<Look> other = looksOf(*findMethod(kReferences[1]), kReferenceRatio * step, cut);
      const double off = difference(one, other);
      double fastest = rate;
      for (const Look& look : one) fastest = std::max(fastest, look.omega.norm());
      // Halving a step of many radians need not help yet.
      const int futile = step * fastest <= 1 ? 1 : 0;
      if (looks_.empty() || off < agreement_) {
        without_progress = off < 0.5 * agreement_ ? 0 : without_progress + futile;
        agreement_ = off;
        looks_ = std::move(one);
        step_ = step;
      } else {
        without_progress += futile;
      }
      if (agreement_ <= kAgree * request_.accuracy) return;
    }
  }

  MotionSetup setup_;
  AccuracyRequest request_;
  const std::atomic<bool>& cancel_;
  Torques torques_;
  std::vector<double> times_;
  std::vector<Look> looks_;
  double step_ = 0, agreement_ = kInfinite;
};

}  // namespace

std::unique_ptr<RefinedTruth> refinedTruth(const MotionSetup& setup, const AccuracyRequest& request,
                                           const std::atomic<bool>& cancel) {
  return std::make_unique<TaylorTruth>(setup, request, cancel);
}

}  // namespace poinsot::cost
