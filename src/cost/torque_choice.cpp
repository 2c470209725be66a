#include "poinsot/cost/torque_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "poinsot/core/no_convergence.h"
#include "poinsot/core/number_text.h"
#include "poinsot/core/rotation.h"
#include "poinsot/core/torque_stepper.h"

namespace poinsot::cost {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kAim = 0.5;           // of the accuracy: what is looked for
constexpr double kMost = 0.8;          // of the accuracy: what is taken, for times between the looks
constexpr double kAgree = 0.1;         // of the accuracy: how far two references should differ at most
constexpr double kAgreeAtWorst = 0.4;  // the same where rounding lets them come no nearer
constexpr double kSlow = 0.01;         // of the greatest |Omega|
constexpr double kRest = 1e-14;        // of the same: what rounding leaves of a spin that was brought to rest
constexpr int kMostLooks = 512;
constexpr double kMostStepsAtAll = 1e9;  // of a motion that is not verified
constexpr double kMostSteps = 2e7;       // of one trial: some seconds
constexpr int kMostTrials = 24;          // to one method
constexpr double kNearEnough = 1.12;     // two steps with this ratio are not told apart
constexpr double kMostCut = 1.02;        // steps taken to steps asked for: beyond it they are cut too often
const char* const kReferences[2] = {"taylor24", "taylor20"};
constexpr double kReferenceRatio = 0.77;  // of their steps: no common grid

struct Look {
  Eigen::Quaterniond attitude;
  Eigen::Vector3d omega;
};

class Search {
 public:
  Search(const MotionSetup& setup, const AccuracyRequest& request, const MethodCosts& costs,
         const std::atomic<bool>& cancel)
      : setup_(setup),
        request_(request),
        costs_(costs),
        cancel_(cancel),
        torques_(sumOf(setup.inertia, setup.effects)) {
    const double ticks = std::ceil(request.horizon * request.rate);
    const int looks = static_cast<int>(std::clamp(ticks, 16.0, double{kMostLooks}));
    for (int k = 1; k <= looks; ++k) times_.push_back(request.horizon * k / looks);
  }

  Choice cheapest() {
    findTruth();
    if (truth_.empty()) {
      throw Unreachable("a reference would take more than " + numberText(kMostSteps, 3) + " steps for " +
                        numberText(request_.horizon, 3) + " s, or loses the motion, so that " +
                        numberText(request_.accuracy, 3) + " rad cannot be verified");
    }
    if (!(agreement_ <= kAgreeAtWorst * request_.accuracy)) {
      throw Unreachable("two references differ by " + numberText(agreement_, 3) + " rad within " +
                        numberText(request_.horizon, 3) + " s, so that " + numberText(request_.accuracy, 3) +
                        " rad cannot be verified: rounding is in the way, or the motion is that sensitive");
    }
    for (const std::string& name : request_.candidates) {
      if (const TorqueMethod* method = findTorqueMethod(name)) tryMethod(*method);
    }
    if (best_.method.empty()) {
      const bool one = request_.candidates.size() == 1;
      const std::string who =
          one ? request_.candidates.front() + " does not keep to "
              : "no method of " + std::to_string(request_.candidates.size()) + " allowed ones keeps to ";
      throw Unreachable(
          who + numberText(request_.accuracy, 3) + " rad for " + numberText(request_.horizon, 3) + " s on this body" +
          (nearest_error_ < 1 ? ": " + nearest_method_ + " comes nearest with about " + numberText(nearest_error_, 3) +
                                    " rad in up to " + numberText(kMostSteps, 3) + " steps"
                              : ", nor comes near in up to " + numberText(kMostSteps, 3) + " steps"));
    }
    return best_;
  }

  Choice mostExact() {
    findTruth();
    if (!(truth_step_ > 0) || request_.horizon / truth_step_ > kMostStepsAtAll) {
      throw Unreachable("this body moves so fast under its effects that " + numberText(request_.horizon, 3) +
                        " s of it take more than " + numberText(kMostStepsAtAll, 3) + " steps");
    }
    return {kReferences[0], truth_step_, agreement_, agreement_, costOf(kReferences[0], truth_step_)};
  }

 private:
  double costOf(const std::string& method, double step) const {
    return costs_.perSimulatedSecond(torqueCostName(method), step, request_.rate);
  }

  /** Where the motion is at all looks; fewer of them where it was lost or cost too much. */
  std::vector<Look> run(const std::string& method, double step, double* cut = nullptr) const {
    std::vector<Look> out;
    if (request_.horizon / step > kMostSteps) return out;
    MotionSetup setup = setup_;
    setup.method = method;
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
    if (cut) {
      const TorqueMethod& m = *findTorqueMethod(method);
      const double steps = std::floor(request_.horizon / step) + static_cast<double>(torques_.switches().size());
      *cut = m.cuts_steps ? static_cast<double>(motion.work().evaluations) / (m.order * std::max(steps, 1.0)) : 1;
    }
    return out;
  }

  /** The greatest difference; infinite where one of them ends early. */
  double difference(const std::vector<Look>& a, const std::vector<Look>& b) const {
    if (a.size() != times_.size() || b.size() != times_.size()) return kInfinite;
    double fastest = 0, worst = 0;
    for (const Look& look : b) fastest = std::max(fastest, look.omega.norm());
    for (std::size_t k = 0; k < a.size(); ++k) {
      // At the horizon Ω is held to what it is there, however slow.
      const double scale = k + 1 == a.size() ? b[k].omega.norm() : std::max(b[k].omega.norm(), kSlow * fastest);
      const bool rests = std::max(a[k].omega.norm(), b[k].omega.norm()) <= kRest * fastest;
      const double off = rests ? 0 : (a[k].omega - b[k].omega).norm();
      worst = std::max({worst, angleBetween(a[k].attitude, b[k].attitude), off > 0 ? off / scale : 0.0});
    }
    return worst;
  }

  /** A rate of the order of the fastest to come [1/s], as far as the start and the strength of the torques tell: a
   * torque that is zero at first (a pendulum upright, a thruster that waits) is not at last. */
  double rateAtStart() const {
    const Eigen::Vector3d& moments = torques_.moments();
    double strongest = 0;
    for (std::size_t k = 0; k <= torques_.switches().size(); ++k) {
      const bool matters = (k == 0 || torques_.switches()[k - 1] < request_.horizon) &&
                           (k == torques_.switches().size() || torques_.switches()[k] > 0);
      if (!matters) continue;
      const Torques::Constant& constant = torques_.constant(k);
      strongest =
          std::max(strongest, constant.body.cwiseQuotient(moments).norm() + constant.world.norm() / moments.minCoeff());
    }
    for (const Torques::Field& field : torques_.fields()) {
      strongest += (moments.cwiseInverse().asDiagonal() * field.map).norm() * field.world.norm();
    }
    double rate = setup_.omega_body.norm() + std::sqrt(strongest);
    if (torques_.gradient()) rate += torques_.gradient()->rate;
    if (torques_.damping()) rate += torques_.damping()->norm() / torques_.moments().minCoeff();
    if (torques_.slug()) {
      rate += torques_.slug()->damping * (1 / torques_.slug()->inertia + 1 / torques_.moments().minCoeff());
    }
    return rate;
  }

  void findTruth() {
    const double rate = rateAtStart();
    double step = rate > 0 ? std::min(request_.horizon, 1 / rate) : request_.horizon;
    agreement_ = kInfinite;
    int without_progress = 0;
    for (int i = 0; i < kMostTrials && without_progress < 3; ++i, step *= 0.5) {
      if (truth_step_ == 0) truth_step_ = step;
      if (request_.horizon / (kReferenceRatio * step) > kMostSteps) return;
      std::vector<Look> one = run(kReferences[0], step), other = run(kReferences[1], kReferenceRatio * step);
      const double off = difference(one, other);
      double fastest = rate;
      for (const Look& look : one) fastest = std::max(fastest, look.omega.norm());
      // Where a step is many radians nothing is to be expected of half of it yet.
      const int futile = step * fastest <= 1 ? 1 : 0;
      if (truth_.empty() || off < agreement_) {
        without_progress = off < 0.5 * agreement_ ? 0 : without_progress + futile;
        agreement_ = off;
        truth_ = std::move(one);
        truth_step_ = step;
      } else {
        without_progress += futile;
      }
      if (agreement_ <= kAgree * request_.accuracy) return;
    }
  }

  /** The longest step that keeps the accuracy and costs less than the best so far. */
  void tryMethod(const TorqueMethod& method) {
    const std::string name = method.name;
    double good = 0, good_error = 0, bad = kInfinite, last_error = kInfinite;
    double step = std::min(request_.horizon, 4 * truth_step_);
    int without_progress = 0;
    for (int i = 0; i < kMostTrials; ++i) {
      if (!best_.method.empty() && costOf(name, step) >= best_.cost) break;
      double cut = 1;
      const double error = difference(run(name, step, &cut), truth_) + agreement_;
      if (error < nearest_error_) {
        nearest_error_ = error;
        nearest_method_ = name;
      }
      const double factor =
          std::pow(kAim * request_.accuracy / std::max(error, 1e-3 * kAim * request_.accuracy), 1.0 / method.order);
      double next;
      if (error <= kMost * request_.accuracy && cut <= kMostCut) {
        good = step;
        good_error = error;
        if (step >= request_.horizon) break;
        next = std::min(request_.horizon, step * std::clamp(factor, 1.2, 4.0));
        if (bad < kInfinite) next = std::min(next, std::sqrt(good * bad));
        if (next < kNearEnough * good) break;
      } else {
        bad = std::min(bad, step);
        if (good > 0) {
          if (bad < kNearEnough * good) break;
          next = std::sqrt(good * bad);
        } else {
          without_progress = error < 0.9 * last_error || !(error < 0.3) ? 0 : without_progress + 1;
          if (without_progress == 4) break;
          next = error < 0.3 ? step * std::clamp(factor, 1e-2, 0.8) : 0.4 * step;
          last_error = error;
          if (request_.horizon / next > kMostSteps) break;
        }
      }
      step = next;
    }
    if (good == 0) return;
    const double cost = costOf(name, good);
    if (best_.method.empty() || cost < best_.cost) best_ = {name, good, good_error, good_error, cost};
  }

  MotionSetup setup_;
  AccuracyRequest request_;
  const MethodCosts& costs_;
  const std::atomic<bool>& cancel_;
  Torques torques_;
  std::vector<double> times_;
  std::vector<Look> truth_;
  double truth_step_ = 0, agreement_ = kInfinite;
  Choice best_;
  std::string nearest_method_;
  double nearest_error_ = kInfinite;
};

}  // namespace

Choice chooseUnderTorques(const MotionSetup& setup, const AccuracyRequest& request, const MethodCosts& costs,
                          const std::atomic<bool>& cancel) {
  return Search(setup, request, costs, cancel).cheapest();
}

Choice mostExactUnderTorques(const MotionSetup& setup, const AccuracyRequest& request, const MethodCosts& costs,
                             const std::atomic<bool>& cancel) {
  return Search(setup, request, costs, cancel).mostExact();
}

}  // namespace poinsot::cost
