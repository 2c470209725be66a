#include "poinsot/core/step_limits.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <vector>

#include "poinsot/core/closed_form.h"
#include "poinsot/core/inertia.h"
#include "poinsot/core/invariants.h"
#include "poinsot/core/no_convergence.h"
#include "poinsot/core/pi.h"
#include "poinsot/core/rotation.h"

namespace poinsot {
namespace {

using Eigen::Vector3d;
using Grade = StepJudgement::Grade;

constexpr double kHopeless = 1, kDoubtful = 0.1;  // rad a turn; the second of E as well
constexpr double kLost = 0.5;                     // of E, of the range of E at that |L|, of |L|
constexpr double kClearlySmall = 0.02;  // of effort(): the error of a turn is then below 0.1 rad, even of first order
constexpr double kMostTurned = 1e15;    // rad a step: beyond, the rounding of the angle alone is 0.1 rad
constexpr int kMostSteps = 64;          // of a trial

std::string format(const char* text, double a, double b = 0) {
  char out[160];
  std::snprintf(out, sizeof out, text, a, b);
  return out;
}

/**
 * The radians that a step takes at the fastest rate of the orbit, times the wobbles to a turn, over which errors of E
 * add up.
 */
double effort(const OrbitRates& rates, double step) {
  return rates.fastest() * step * (rates.wobble > rates.turn ? rates.wobble / rates.turn : 1);
}

/** A method at a step on the orbit of a body. */
class Trial {
 public:
  Trial(const Method& method, const Vector3d& moments, const Vector3d& omega)
      : moments_(moments), rates_(orbitRates(moments, omega)), stepper_(method.make(moments)) {
    findPlaces(omega);
  }

  const OrbitRates& rates() const { return rates_; }

  /** Without largest_sound. @param step > 0 */
  StepJudgement at(double step) const {
    if (effort(rates_, step) < kClearlySmall) return {};
    if (rates_.turn * step > kMostTurned) {
      return {Grade::hopeless,
              format("the body turns by %.2g rad in a step, which doubles cannot tell from another angle",
                     rates_.turn * step),
              0};
    }
    Worst worst;
    for (const RotationState& place : places_) {
      runFrom(place, step, worst);
      if (!worst.broken.empty()) return {Grade::hopeless, worst.broken, 0};
    }
    return judgement(worst, step);
  }

 private:
  struct Worst {
    double angle = 0;  ///< a turn, or a step where that is longer [rad]
    double energy = 0, momentum = 0;
    double energy_of_turn = 0;
    std::string broken;
  };

  void add(const ClosedForm& orbit, double t) {
    const ClosedForm::State state = orbit.at(t);
    places_.push_back(RotationState::fromOmega(moments_, state.attitude, state.omega_principal));
  }

  /** Where to try: evenly along a period, and densely about the next flip, which may be a small part of it. */
  void findPlaces(const Vector3d& omega) {
    const ClosedForm orbit(moments_, Eigen::Quaterniond::Identity(), omega);
    add(orbit, 0);
    if (orbit.regime() == ClosedForm::Regime::steady) return;
    const double turn = 2 * kPi / rates_.turn, period = orbit.period(), flip = orbit.timeToNextFlip(0);
    const double far = std::isfinite(period) ? std::min(period, 1e5 * turn) : 4 * turn;
    for (int i = 1; i < 12; ++i) add(orbit, i / 12.0 * far);
    if (!std::isfinite(flip)) return;
    for (int i = -6; i <= 6; ++i) add(orbit, flip + i / 4.0 * turn);
  }

  /**
   * Attitudes are compared over a turn. E and |L| over more, where a step is so long that the smallest disturbance may
   * grow from step to step.
   */
  void runFrom(const RotationState& place, double step, Worst& worst) const {
    const double steps_in_turn = 2 * kPi / rates_.turn / step;
    const int compared = static_cast<int>(std::clamp(std::ceil(steps_in_turn), 1.0, double(kMostSteps)));
    const int steps = rates_.fastest() * step > 1 ? kMostSteps : compared;
    const double per_turn = std::max(1.0, steps_in_turn / compared);
    const ClosedForm truth(moments_, place.attitude, place.omegaPrincipal(moments_));
    const double scale = place.momentum_principal.stableNorm();
    const double energy = energyOf(place, scale), range = 0.5 * (1 / moments_.minCoeff() - 1 / moments_.maxCoeff());
    const double tolerance = kLost * std::min(energy, range * moments_.maxCoeff()) + 1e-12 * energy;
    const double lowest = 0.5, highest = 0.5 * moments_.maxCoeff() / moments_.minCoeff();
    RotationState state = place;
    for (int n = 1; n <= steps; ++n) {
      try {
        stepper_->advance(state, 0, step, 1);
      } catch (const NoConvergence& error) {
        worst.broken = error.what();
        return;
      }
      if (!state.attitude.coeffs().allFinite() || !state.omegaPrincipal(moments_).allFinite()) {
        worst.broken =
            "the state becomes infinite or undefined after " + std::to_string(n) + (n == 1 ? " step" : " steps");
        return;
      }
      worst.energy = std::max(worst.energy, kLost * std::abs(energyOf(state, scale) - energy) / tolerance);
      worst.momentum = std::max(worst.momentum, std::abs(state.momentum_principal.stableNorm() / scale - 1));
      if (n > compared) continue;
      if (n == compared && per_turn > 1) {
        // E leaves the end of its range exponentially, and comes to rest at the other.
        const double change = energyOf(state, scale) - energy, real = std::max(0.0, std::abs(change) - 1e-12 * energy);
        const double away = (change > 0 ? energy - lowest : highest - energy), share = away / (highest - lowest);
        const double growth = std::exp(std::min(500.0, real == 0 ? 0 : per_turn * real / (away * (1 - share))));
        const double in_turn = away * growth / (1 + share * (growth - 1)) - away;
        worst.energy_of_turn = std::max(worst.energy_of_turn, kLost * in_turn / tolerance);
      }
      worst.angle = std::max(worst.angle, per_turn * angleBetween(truth.at(n * step).attitude, state.attitude));
    }
  }

  /** E μ_max/|L|², whatever the scale of the body. */
  double energyOf(const RotationState& state, double scale) const {
    const Vector3d p = state.momentum_principal / scale;
    return 0.5 * p.dot(p.cwiseQuotient(moments_ / moments_.maxCoeff()));
  }

  StepJudgement judgement(const Worst& worst, double step) const;

  Vector3d moments_;
  OrbitRates rates_;
  std::unique_ptr<Stepper> stepper_;
  std::vector<RotationState> places_;
};

StepJudgement Trial::judgement(const Worst& worst, double step) const {
  const double turned = rates_.turn * step;  // in a step [rad]
  const std::string when = turned < 2 * kPi ? format("in a turn of the body (%.3g steps)", 2 * kPi / turned)
                                            : format("in one step (%.3g turns of the body)", turned / (2 * kPi));
  const std::string angle = "the attitude goes wrong by " + format("%.2g rad ", std::min(worst.angle, kPi)) + when;
  if (!(worst.angle <= (turned > kPi ? kDoubtful : kHopeless))) return {Grade::hopeless, angle, 0};
  const std::string within =
      format(" within %.0f steps (%.2g turns of the body)", kMostSteps, kMostSteps * turned / (2 * kPi));
  if (!(worst.energy <= kLost)) return {Grade::hopeless, "the kinetic energy goes wrong by more than half" + within, 0};
  if (!(worst.energy_of_turn <= kLost))
    return {Grade::hopeless, "the kinetic energy goes wrong by more than half " + when, 0};
  if (!(worst.momentum <= kLost))
    return {Grade::hopeless, "the angular momentum goes wrong by more than half" + within, 0};
  if (worst.angle > kDoubtful) return {Grade::doubtful, angle, 0};
  if (worst.energy_of_turn > kDoubtful) {
    return {Grade::doubtful, format("the kinetic energy goes wrong by %.0f %% ", 100 * worst.energy_of_turn) + when, 0};
  }
  if (turned > kPi) {
    return {
        Grade::doubtful,
        format("the body turns by %.3g rad in a step; it is followed only because its motion is so regular", turned),
        0};
  }
  return {};
}

/** The longest step/2ᵏ that is sound; all below clearly small ones are. */
double largestSound(const Trial& trial, double step) {
  const double most = std::log2(effort(trial.rates(), 1)) + std::log2(step) - std::log2(kClearlySmall);
  int bad = 0, good = static_cast<int>(std::ceil(std::max(most, 0.0))) + 1;
  while (good - bad > 1) {
    const int middle = (bad + good) / 2;
    (trial.at(std::ldexp(step, -middle)).grade == Grade::sound ? good : bad) = middle;
  }
  return std::ldexp(step, -good);
}

}  // namespace

/**
 * On the orbit |Ω|² is greatest where Ω_b = 0 (b the axis of intermediate moment) if it gets there, and never above
 * what E and L say of that point: Ω_a² + Ω_c² + Ω_b² μ_b(μ_a + μ_c − μ_b)/(μ_a μ_c), a sum of positive terms.
 */
OrbitRates orbitRates(const Vector3d& moments, const Vector3d& omega) {
  const double size = omega.cwiseAbs().maxCoeff();
  if (size == 0) return {0, 0};
  const std::array<int, 3> axis = ascendingAxes(moments);
  const double a = moments[axis[0]], b = moments[axis[1]], c = moments[axis[2]];
  const Vector3d o(omega[axis[0]] / size, omega[axis[1]] / size, omega[axis[2]] / size);
  const double turn = std::sqrt(o[0] * o[0] + o[2] * o[2] + o[1] * o[1] * (b / a) * ((a - b) / c + 1));
  const double wobble = Vector3d(a / c * o[0], b / c * o[1], o[2]).norm() * ((c - a) / a);
  return {size * turn, size * wobble};
}

StepJudgement judgeStep(const Method& method, const Vector3d& moments, const Vector3d& omega_principal, double step) {
  const OrbitRates rates = orbitRates(moments, omega_principal);
  if (effort(rates, std::abs(step)) < kClearlySmall) return {};
  try {
    // Backwards is the same as forwards from −Ω, for the body and for every method.
    const Trial trial(method, moments, step < 0 ? Vector3d(-omega_principal) : omega_principal);
    StepJudgement judgement = trial.at(std::abs(step));
    if (judgement.grade != Grade::sound) judgement.largest_sound = largestSound(trial, std::abs(step));
    return judgement;
  } catch (const std::exception& error) {
    return {Grade::hopeless, error.what(), 0};
  }
}

}  // namespace poinsot
