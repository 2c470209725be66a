#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>

#include "poinsot/core/method.h"
#include "poinsot/core/rotation.h"
#include "poinsot/core/step_limits.h"

namespace poinsot {
namespace {

using Grade = StepJudgement::Grade;

constexpr int kSteps = 64;
constexpr double kHopeless = 1, kDoubtful = 0.1;  // rad
constexpr int kMostHalvings = 400;                // those of steps that are hopeless at once cost nothing

std::string format(const char* text, double value) {
  char out[128];
  std::snprintf(out, sizeof out, text, value);
  return out;
}

class Trial {
 public:
  Trial(const Method& method, const Torques& torques, const RotationState& start)
      : stepper_(method.make(torques)), truth_(findMethod("taylor24")->make(torques)), start_(start) {}

  StepJudgement at(double step) const {
    RotationState state = start_, truth = start_;
    double worst = 0;
    for (int n = 0; n < kSteps; ++n) {
      try {
        stepper_->advance(state, n, step, 1);
      } catch (const std::exception& error) {
        return {Grade::hopeless, error.what(), 0};
      }
      truth_->advance(truth, n, step, 1);
      if (!truth.momentum_principal.allFinite()) {
        return {Grade::hopeless, "it is so long that the motion cannot be followed in 262144 parts of it either", 0};
      }
      const double angle = angleBetween(state.attitude, truth.attitude);
      if (!state.momentum_principal.allFinite() || !(angle <= kHopeless)) {
        return {Grade::hopeless, format("the attitude goes wrong by more than 1 rad within %.0f steps", n + 1), 0};
      }
      worst = std::max(worst, angle);
    }
    if (worst <= kDoubtful) return {};
    return {Grade::doubtful,
            format("the attitude goes wrong by %.2g rad", worst) + format(" within %.0f steps", kSteps), 0};
  }

 private:
  std::unique_ptr<Stepper> stepper_, truth_;
  RotationState start_;
};

}  // namespace

StepJudgement judgeStep(const Method& method, const Torques& torques, const Quaternion& attitude,
                        const Eigen::Vector3d& omega_principal, double step) {
  if (method.cuts_steps) return {};
  RotationState start = RotationState::fromOmega(torques.moments(), attitude, omega_principal);
  if (torques.slug()) start.slug_omega = omega_principal;
  const Trial trial(method, torques, start);
  StepJudgement judgement = trial.at(step);
  for (int i = 0; judgement.grade != Grade::sound && judgement.largest_sound == 0 && i < kMostHalvings; ++i) {
    step *= 0.5;
    if (trial.at(step).grade == Grade::sound) judgement.largest_sound = step;
  }
  return judgement;
}

}  // namespace poinsot
