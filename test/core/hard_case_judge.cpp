#include "hard_case_judge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <set>

#include "poinsot/core/closed_form.h"
#include "poinsot/core/no_convergence.h"
#include "poinsot/core/rotation.h"

namespace poinsot {
namespace {

using Eigen::Vector3d;
using Real = long double;  // wide enough for squares of anything that a double holds
using Vector = Eigen::Matrix<Real, 3, 1>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = 3.14159265358979323846;
constexpr double kSmallestNumber = 5e-324;
constexpr double kRoundoff = 1e-14;  // rad

struct Exact {
  Real norm, energy;
  Vector momentum;  ///< world axes
};

Exact exactly(const Vector3d& moments, const Eigen::Quaterniond& attitude, const Vector& momentum_principal) {
  const Eigen::Quaternion<Real> q = attitude.cast<Real>();
  const Vector omega = momentum_principal.cwiseQuotient(moments.cast<Real>());
  return {q.norm(), momentum_principal.dot(omega) / 2, q.normalized() * momentum_principal};
}

double relative(Real difference, Real reference) {
  return static_cast<double>(difference == 0 ? 0 : difference / reference);
}

/** Numbers of steps at which to look: the first ones, a turn in 16 parts, and the whole run in 64. */
std::set<std::int64_t> looks(const HardCase& c, double turn) {
  std::set<std::int64_t> out;
  const double steps_in_turn = std::max(1.0, std::ceil(2 * kPi / turn / std::abs(c.step)));
  for (std::int64_t n = 1; n <= 8; ++n) out.insert(n);
  if (steps_in_turn < static_cast<double>(c.steps)) {
    for (int i = 1; i <= 16; ++i) out.insert(static_cast<std::int64_t>(std::ceil(steps_in_turn * i / 16)));
  }
  for (int i = 1; i <= 64; ++i) out.insert(c.steps * i / 64);
  return out;
}

/** Keeps the books of a run. */
class Run {
 public:
  explicit Run(const HardCase& c)
      : case_(c),
        start_(exactly(c.moments, c.attitude, momentumOf(c))),
        lowest_(momentumOf(c).squaredNorm() / 2 / c.moments.maxCoeff()),
        highest_(momentumOf(c).squaredNorm() / 2 / c.moments.minCoeff()) {}

  /** False once the state is not finite. */
  bool look(std::int64_t n, const Eigen::Quaterniond& attitude, const Vector& momentum_principal) {
    measured.looked_at = n;
    if (!attitude.coeffs().allFinite() || !momentum_principal.allFinite()) {
      measured.finite = false;
      return false;
    }
    const Exact now = exactly(case_.moments, attitude, momentum_principal);
    const auto atMost = [](double& worst, Real value) { worst = std::max(worst, static_cast<double>(value)); };
    atMost(measured.norm, std::abs(now.norm - 1));
    atMost(measured.momentum, relative((now.momentum - start_.momentum).norm(), start_.momentum.norm()));
    atMost(measured.energy, std::abs(relative(now.energy - start_.energy, start_.energy)));
    atMost(measured.energy_outside, relative(std::max(lowest_ - now.energy, now.energy - highest_), start_.energy));
    measured.energy_at_end = relative(now.energy - lowest_, highest_ - lowest_);
    return true;
  }

  static Vector momentumOf(const HardCase& c) { return c.moments.cwiseProduct(c.omega).cast<Real>(); }

  Measured measured;

 private:
  const HardCase& case_;
  Exact start_;
  Real lowest_, highest_;
};

/** How much of E's roundoff is the method's: dE = Ω·dΛ, so |dE|/E ≤ (|Ω||L|/E)·|dΛ|/|L|, all along the orbit. */
double conditionOfEnergy(const HardCase& c, double turn) {
  const Vector momentum = Run::momentumOf(c);
  const Real energy = momentum.dot(c.omega.cast<Real>()) / 2;
  return energy == 0 ? 0 : static_cast<double>(turn * momentum.norm() / energy);
}

/** The relative error of L by denormal numbers; the result of each batch is rounded. */
double granularity(const HardCase& c) {
  const Real size = Run::momentumOf(c).norm();
  return size == 0 ? 0 : static_cast<double>(1000 * static_cast<Real>(kSmallestNumber) / size);
}

}  // namespace

Measured measure(const Method& method, const HardCase& c) {
  const auto stepper = method.make(c.moments);
  const OrbitRates rates = orbitRates(c.moments, c.omega);
  const ClosedForm truth(c.moments, c.attitude, c.omega);
  const Real in_step = std::min<Real>(1, rates.turn * static_cast<Real>(std::abs(c.step)) / (2 * kPi));  // of a turn
  RotationState state = RotationState::fromOmega(c.moments, c.attitude, c.omega);
  Run run(c);
  std::int64_t n = 0;
  for (const std::int64_t next : looks(c, rates.turn)) {
    try {
      stepper->advance(state, 0, c.step, next - n);
    } catch (const NoConvergence&) {
      state.attitude.coeffs().setConstant(std::numeric_limits<double>::quiet_NaN());  // no state: as good as none
    }
    n = next;
    if (!run.look(n, state.attitude, state.momentum_principal.cast<Real>())) break;
    const double error = angleBetween(truth.at(static_cast<double>(n) * c.step).attitude, state.attitude);
    run.measured.attitude = std::max(run.measured.attitude, error);
    const double done = static_cast<double>(n * in_step);
    if (done > 0 && (n == 1 || done < 1 + 1e-9)) {
      run.measured.first_turn =
          std::max(run.measured.first_turn, std::max(0.0, error - kRoundoff - granularity(c)) / std::min(1.0, done));
    }
  }
  return run.measured;
}

Measured measureClosedForm(const HardCase& c) {
  const ClosedForm form(c.moments, c.attitude, c.omega);
  Run run(c);
  for (const std::int64_t n : looks(c, orbitRates(c.moments, c.omega).turn)) {
    const ClosedForm::State state = form.at(static_cast<double>(n) * c.step);
    if (!run.look(n, state.attitude, c.moments.cast<Real>().cwiseProduct(state.omega_principal.cast<Real>()))) break;
  }
  return run.measured;
}

/**
 * Roundoff in a turn of the body. A splitting composes its step of turns that cancel: where the body turns little
 * beside its wobble (moments 1e12 : 1 : 3), they are 1e11 times as large as their sum.
 */
double roundoffOfATurn(const Method& method, const HardCase& c, double turn) {
  const double of_a_step = std::string(method.name).rfind("splitting", 0) == 0 ? 4e-16 : 1e-16;
  return turn > 0 ? of_a_step * 2 * kPi / (turn * std::abs(c.step)) : 0;
}

Promise promiseOf(const Method& method, const HardCase& c, const StepJudgement& judgement) {
  using Grade = StepJudgement::Grade;
  const OrbitRates rates = orbitRates(c.moments, c.omega);
  const double steps = static_cast<double>(c.steps), wh = rates.fastest() * std::abs(c.step);
  const double wt = wh * steps, condition = conditionOfEnergy(c, rates.turn);
  const double roundoff = condition * (1e-15 * (20 + std::sqrt(steps)) + granularity(c));
  // The bound by the order for each radian turned: C (wh)^p.
  const bool hopeless = judgement.grade == Grade::hopeless;
  const double of_order = hopeless ? kInfinity : std::pow(wh, method.order);
  const double drift = (method.order == 1 ? 2 : 0.2) * of_order * (1 + wt);
  const double error = std::min(2 * kPi * 5 * of_order, judgement.grade == Grade::sound ? 0.1 : 1.0);
  Promise promise;
  promise.norm = 1e-15;
  promise.momentum = method.conserves_momentum ? 4e-15 + granularity(c) : roundoff + drift;
  promise.energy = hopeless                  ? kInfinity
                   : method.conserves_energy ? condition * (4e-15 + granularity(c))
                                             : roundoff + drift;
  promise.energy_outside = method.conserves_momentum ? 1e-14 * condition + roundoff : kInfinity;
  promise.first_turn =
      hopeless ? kInfinity : kRoundoff * rates.turn * std::abs(c.step) + error + roundoffOfATurn(method, c, rates.turn);
  promise.must_be_finite = !hopeless;
  return promise;
}

Promise promiseOfClosedForm(const HardCase& c) {
  const double condition = conditionOfEnergy(c, orbitRates(c.moments, c.omega).turn);
  Promise promise;
  promise.norm = 1e-15;
  promise.momentum = 4e-15 + granularity(c);
  promise.energy = condition * (4e-15 + granularity(c));
  promise.energy_outside = promise.energy;
  promise.first_turn = kInfinity;
  promise.must_be_finite = true;
  return promise;
}

std::vector<std::string> broken(const Promise& promise, const Measured& measured) {
  std::vector<std::string> out;
  const auto check = [&out](const char* what, double figure, double bound) {
    if (figure <= bound) return;
    char text[160];
    std::snprintf(text, sizeof text, "%s is %.2g, at most %.2g is promised", what, figure, bound);
    out.push_back(text);
  };
  if (promise.must_be_finite && !measured.finite) {
    out.push_back("the state is not finite after " + std::to_string(measured.looked_at) + " steps");
  }
  check("the error of the norm", measured.norm, promise.norm);
  check("the change of L", measured.momentum, promise.momentum);
  check("the change of E", measured.energy, promise.energy);
  check("E beyond what L allows", measured.energy_outside, promise.energy_outside);
  check("the error of the attitude in the first turn", measured.first_turn, promise.first_turn);
  return out;
}

std::string wronglyRefused(const StepJudgement& judgement, const Measured& measured) {
  if (judgement.grade != StepJudgement::Grade::hopeless || !measured.finite) return "";
  if (measured.attitude > 1 || measured.energy > 0.25 || measured.momentum > 0.25) return "";
  return "called hopeless (" + judgement.reason + "), but was off by " + std::to_string(measured.attitude) + " rad";
}

}  // namespace poinsot
