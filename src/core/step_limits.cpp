#include "poinsot/core/step_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "poinsot/core/closed_form.h"
#include "poinsot/core/inertia.h"
#include "poinsot/core/invariants.h"
#include "poinsot/core/number_text.h"
#include "poinsot/core/pi.h"
#include "poinsot/core/rotation.h"

namespace poinsot {
namespace {

using Eigen::Vector3d;
using Grade = StepJudgement::Grade;

constexpr double kHopeless = 1, kDoubtful = 0.1;  // errors of the attitude [rad]; kDoubtful also a relative one of E
constexpr double kLost = 0.5;                     // of E, of the range of E at that |L|, of |L|
constexpr double kClearlySmall = 0.02;  // of effort(): the error of a turn is then below 0.1 rad, even of first order
constexpr double kMostTurned = 1e15;    // rad a step: above it, rounding the angle costs 0.1 rad or more
constexpr int kMostSteps = 64;          // of a trial
constexpr int kMostHalvings = 400;      // of a step under torques; trials of hopeless steps end soon

/** Takes step n, counted from 0. Returns why the state cannot be used afterwards; empty where it can. */
std::string takeStep(const Stepper& stepper, const Vector3d& moments, int n, double step, RotationState& state) {
  try {
    stepper.advance(state, n, step, 1);
  } catch (const std::exception& error) {
    return error.what();
  }
  if (state.attitude.coeffs().allFinite() && state.omegaPrincipal(moments).allFinite()) return "";
  return "the state becomes infinite or undefined after " + std::to_string(n + 1) + (n == 0 ? " step" : " steps");
}

/**
 * Returns the angle of a step at the fastest rate of the orbit [rad], times the number of wobbles in a turn where that
 * is above 1: over those, errors of E add up.
 */
double effort(const OrbitRates& rates, double step) {
  return rates.fastest() * step * (rates.wobble > rates.turn ? rates.wobble / rates.turn : 1);
}

/** Tries a method on the orbit of a free body. */
class Trial {
 public:
  Trial(const Method& method, const Vector3d& moments, const Vector3d& omega)
      : moments_(moments), rates_(orbitRates(moments, omega)), stepper_(method.make(moments)) {
    findPlaces(omega);
  }

  const OrbitRates& rates() const { return rates_; }

  /** Returns the judgement of a step, without largest_sound. @param step [s], > 0. */
  StepJudgement at(double step) const {
    if (effort(rates_, step) < kClearlySmall) return {};
    if (rates_.turn * step > kMostTurned) {
      return {Grade::hopeless, "the body turns by " + numberText(rates_.turn * step, 2) +
                                   " rad in a step, which doubles cannot tell from another angle"};
    }
    Worst worst;
    for (const RotationState& place : places_) {
      runFrom(place, step, worst);
      if (!worst.broken.empty()) return {Grade::hopeless, worst.broken};
    }
    return judgement(worst, step);
  }

 private:
  struct Worst {
    double angle = 0;                 ///< error of the attitude in a turn, or in a step where that is longer [rad]
    double energy = 0, momentum = 0;  ///< relative errors of E and |L| in all steps
    double energy_of_turn = 0;        ///< relative error of E in a turn
    std::string broken;               ///< why a state could not be used
  };

  void add(const ClosedForm& orbit, double t) {
    const ClosedForm::State state = orbit.at(t);
    places_.push_back(RotationState::fromOmega(moments_, state.attitude, state.omega_principal));
  }

  /** Chooses where to try: evenly along a period, and densely about the next flip, which may be a small part of it. */
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
   * Compares attitudes over a turn; E and |L| over more steps where a step is so long that the smallest disturbance may
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
      worst.broken = takeStep(*stepper_, moments_, n - 1, step, state);
      if (!worst.broken.empty()) return;
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

  /** Returns E μ_max/|L|², which does not depend on the scale of the body. */
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
  const std::string when = turned < 2 * kPi
                               ? " in a turn of the body (" + numberText(2 * kPi / turned, 3) + " steps)"
                               : " in one step (" + numberText(turned / (2 * kPi), 3) + " turns of the body)";
  const std::string angle = "the attitude goes wrong by " + numberText(std::min(worst.angle, kPi), 2) + " rad" + when;
  if (!(worst.angle <= (turned > kPi ? kDoubtful : kHopeless))) return {Grade::hopeless, angle};
  const std::string within = " within " + std::to_string(kMostSteps) + " steps (" +
                             numberText(kMostSteps * turned / (2 * kPi), 2) + " turns of the body)";
  const std::string energy = "the kinetic energy goes wrong by ", half = "more than half";
  if (!(worst.energy <= kLost)) return {Grade::hopeless, energy + half + within};
  if (!(worst.energy_of_turn <= kLost)) return {Grade::hopeless, energy + half + when};
  if (!(worst.momentum <= kLost)) return {Grade::hopeless, "the angular momentum goes wrong by " + half + within};
  if (worst.angle > kDoubtful) return {Grade::doubtful, angle};
  if (worst.energy_of_turn > kDoubtful) {
    return {Grade::doubtful, energy + numberText(100 * worst.energy_of_turn, 2) + " %" + when};
  }
  if (turned > kPi) {
    return {Grade::doubtful, "the body turns by " + numberText(turned, 3) +
                                 " rad in a step; it is followed only because its motion is so regular"};
  }
  return {};
}

/** Returns the longest step/2ᵏ that is sound; all that are clearly small are. */
double largestSound(const Trial& trial, double step) {
  const double most = std::log2(effort(trial.rates(), 1)) + std::log2(step) - std::log2(kClearlySmall);
  int bad = 0, good = static_cast<int>(std::ceil(std::max(most, 0.0))) + 1;
  while (good - bad > 1) {
    const int middle = (bad + good) / 2;
    (trial.at(std::ldexp(step, -middle)).grade == Grade::sound ? good : bad) = middle;
  }
  return std::ldexp(step, -good);
}

/** Returns the judgement of a step of a body under torques, without largest_sound. */
StepJudgement judgedAgainst(const Stepper& truth, const Stepper& stepper, const Vector3d& moments,
                            const RotationState& start, double step) {
  RotationState state = start, true_state = start;
  double worst = 0;
  for (int n = 0; n < kMostSteps; ++n) {
    const std::string broken = takeStep(stepper, moments, n, step, state);
    if (!broken.empty()) return {Grade::hopeless, broken};
    truth.advance(true_state, n, step, 1);
    if (!true_state.momentum_principal.allFinite()) {
      return {Grade::hopeless, "it is so long that the motion cannot be followed in 262144 parts of it either"};
    }
    const double angle = angleBetween(state.attitude, true_state.attitude);
    if (!(angle <= kHopeless)) {
      return {Grade::hopeless, "the attitude goes wrong by more than 1 rad within " + std::to_string(n + 1) +
                                   (n == 0 ? " step" : " steps")};
    }
    worst = std::max(worst, angle);
  }
  if (worst <= kDoubtful) return {};
  return {Grade::doubtful, "the attitude goes wrong by " + numberText(worst, 2) + " rad within " +
                               std::to_string(kMostSteps) + " steps"};
}

}  // namespace

/**
 * On the orbit |Ω|² is greatest where Ω_b = 0 (b the axis of intermediate moment) if it gets there, and never above
 * what E and L give for that point: Ω_a² + Ω_c² + Ω_b² μ_b(μ_a + μ_c − μ_b)/(μ_a μ_c), a sum of positive terms.
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
    return {Grade::hopeless, error.what()};
  }
}

StepJudgement judgeStep(const Method& method, const Torques& torques, const Quaternion& attitude,
                        const Vector3d& omega_principal, double step) {
  if (method.cuts_steps) return {};
  const Vector3d& moments = torques.moments();
  RotationState start = RotationState::fromOmega(moments, attitude, omega_principal);
  if (torques.slug()) start.slug_omega = omega_principal;
  const auto stepper = method.make(torques), truth = findMethod("taylor24")->make(torques);
  StepJudgement judgement = judgedAgainst(*truth, *stepper, moments, start, step);
  for (int i = 0; judgement.grade != Grade::sound && judgement.largest_sound == 0 && i < kMostHalvings; ++i) {
    step *= 0.5;
    if (judgedAgainst(*truth, *stepper, moments, start, step).grade == Grade::sound) judgement.largest_sound = step;
  }
  return judgement;
}

}  // namespace poinsot
