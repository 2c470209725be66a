#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "poinsot/core/rotation.h"
#include "poinsot/core/step_limits.h"

namespace poinsot {
namespace {

using Grade = StepJudgement::Grade;

constexpr int kSteps = 64;
constexpr int kParts = 16;                        // of a step, for the truth
constexpr int kMostStarts = 8;                    // t = 0 and switches after it
constexpr double kHopeless = 1, kDoubtful = 0.1;  // rad
constexpr int kMostHalvings = 400;                // those of steps that are hopeless at once cost nothing

std::string format(const char* text, double value) {
  char out[128];
  std::snprintf(out, sizeof out, text, value);
  return out;
}

class Trial {
 public:
  Trial(const TorqueMethod& method, const Torques& torques, const TorquedState& start, double sign)
      : stepper_(method.make(torques)), truth_(findTorqueMethod("taylor24")->make(torques)) {
    // What a switch sets going is not to be seen from the start.
    starts_.push_back({0, start});
    std::vector<double> switches = torques.switches();
    if (sign < 0) std::reverse(switches.begin(), switches.end());
    for (const double t : switches) {
      const Place last = starts_.back();
      if (!(sign * t > 0) || starts_.size() == kMostStarts) continue;
      Place next{t, last.state};
      for (int i = 0; i < kParts; ++i) follow(next.state, last.time, t - last.time, i);
      if (!next.state.rotation.momentum_body.allFinite()) break;
      starts_.push_back(next);
    }
  }

  StepJudgement at(double step) const {
    StepJudgement worst;
    for (const Place& start : starts_) {
      const StepJudgement judgement = from(start, step);
      if (judgement.grade > worst.grade) worst = judgement;
    }
    return worst;
  }

 private:
  struct Place {
    double time;
    TorquedState state;
  };

  /** Part i of a step from t. */
  void follow(TorquedState& state, double t, double step, int i) const {
    truth_->advance(state, t + i * (step / kParts), step / kParts);
  }

  StepJudgement from(const Place& start, double step) const {
    TorquedState state = start.state, truth = start.state;
    double worst = 0;
    for (int n = 0; n < kSteps; ++n) {
      try {
        stepper_->advance(state, start.time + n * step, step);
      } catch (const std::exception& error) {
        return {Grade::hopeless, error.what(), 0};
      }
      for (int i = 0; i < kParts; ++i) follow(truth, start.time + n * step, step, i);
      if (!truth.rotation.momentum_body.allFinite()) {
        return {Grade::hopeless, "it is so long that the motion cannot be followed in 65536 parts of it either", 0};
      }
      const double angle = angleBetween(state.rotation.attitude, truth.rotation.attitude);
      if (!state.rotation.momentum_body.allFinite() || !(angle <= kHopeless)) {
        return {Grade::hopeless, format("the attitude goes wrong by more than 1 rad within %.0f steps", n + 1), 0};
      }
      worst = std::max(worst, angle);
    }
    if (worst <= kDoubtful) return {};
    return {Grade::doubtful,
            format("the attitude goes wrong by %.2g rad", worst) + format(" within %.0f steps", kSteps), 0};
  }

  std::unique_ptr<TorqueStepper> stepper_, truth_;
  std::vector<Place> starts_;
};

}  // namespace

StepJudgement judgeTorqueStep(const TorqueMethod& method, const Torques& torques, const Eigen::Quaterniond& attitude,
                              const Eigen::Vector3d& omega_body, double step) {
  TorquedState start;
  start.rotation = RotationState::fromOmega(torques.moments(), attitude, omega_body);
  if (torques.slug()) start.slug_omega = omega_body;
  const Trial trial(method, torques, start, step);
  StepJudgement judgement = trial.at(step);
  for (int i = 0; judgement.grade != Grade::sound && judgement.largest_sound == 0 && i < kMostHalvings; ++i) {
    step *= 0.5;
    if (trial.at(step).grade == Grade::sound) judgement.largest_sound = step;
  }
  return judgement;
}

}  // namespace poinsot
