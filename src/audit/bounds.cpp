#include "bounds.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "poinsot/audit/report.h"

namespace poinsot::audit {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kSameAttitude = 1e-15;  // rad: of the closed form against itself
constexpr double kUnknown = 1e-3;        // of the turn

// Free bodies: C for each order, several times the errors of random bodies, so that no working method fails.
constexpr double kNotMeasured = 0.2, kFreeStep = 0.6;

// Bodies under torques.
constexpr double kStep = 2;          // C of the error C r^(p+1) of a step, r as in pace()
constexpr double kFree8 = 1e-6;      // the same for the free motion in aba84
constexpr double kSafety = 4;        // factor on the remainder of a Taylor series
constexpr double kHalvedAt = 1e-2;   // Taylor methods halve steps whose last two terms are larger
constexpr int kMostLooks = 500;      // states of a motion whose Taylor series is worked out
constexpr double kTooCoarse = 1e-2;  // error of a step above which the accuracy of the description is the bound
constexpr double kAccuracy = 4;      // factor on that accuracy

constexpr FreeMethod kMethods[] = {
    {"closed_form", 0, true, true, 0},
    {"lie_euler", 1, true, false, 2},
    {"buss2", 2, true, false, 0.06},
    {"buss3", 3, true, false, kNotMeasured},
    {"buss4", 4, true, false, kNotMeasured},
    {"rk4", 4, false, false, 2e-3},
    {"rkmk4", 4, true, false, kNotMeasured},
    {"cf4", 4, true, false, kNotMeasured},
    {"midpoint", 2, true, false, kNotMeasured},
    {"splitting2", 2, true, false, kNotMeasured},
    {"splitting4", 4, true, false, kNotMeasured},
    {"splitting6", 6, true, false, kNotMeasured},
    {"dmv2", 2, true, true, 0},
    {"dmv4", 4, true, true, 0},
    {"dmv6", 6, true, true, 0},
    {"dmv8", 8, true, true, 0},
    {"dmv10", 10, true, true, 0},
};

/** Returns the order in "taylor16", or 0. */
int taylorOrder(const std::string& method) {
  if (method.compare(0, 6, "taylor") != 0) return 0;
  const int order = std::atoi(method.c_str() + 6);
  return order >= 2 && order <= 24 ? order : 0;
}

/** Returns a bound of the remainder of a Taylor step: its next two terms, and the geometric series behind them. */
double remainder(const std::vector<double>& terms, int order, double shrink) {
  const double a = terms[order + 1] * std::pow(shrink, order + 1), b = terms[order + 2] * std::pow(shrink, order + 2);
  const double ratio = std::max(std::pow(a, 1.0 / (order + 1)), std::pow(b, 1.0 / (order + 2)));
  return kSafety * (a + b) / (1 - std::min(ratio, 0.9));
}

/** Returns how far a motion goes in a step, by all its derivatives: max (|aₖ|hᵏ)^(1/k), k ≥ 1. */
double pace(const std::vector<double>& terms) {
  double r = 0;
  for (std::size_t k = 1; k < terms.size(); ++k) r = std::max(r, std::pow(terms[k], 1.0 / static_cast<double>(k)));
  return r;
}

}  // namespace

Phase phaseOf(const RigidBody& body, const State& s) {
  Phase p{s.attitude, s.omega_body};
  if (const double j = body.slugInertia(); j > 0) {
    p.slug_omega = (s.attitude.conjugate() * s.momentum_world - body.inertia().tensor * s.omega_body) / j;
  }
  return p;
}

Bounds::Bounds(const Description& description, const RigidBody& body, const std::vector<const State*>& states)
    : inertia_(body.inertia()),
      free_(description.isFree()),
      method_(description.method),
      step_(description.step),
      accuracy_(description.accuracy) {
  const bool has_step = step_ > 0 && std::isfinite(step_);
  for (const FreeMethod& row : kMethods) {
    if (free_ && method_ == row.name) row_ = row;
  }
  const bool listed =
      free_ ? exact() || (row_.order > 0 && has_step)
            : has_step && (taylorOrder(method_) > 0 || method_ == "rk4" || method_ == "buss2" || method_ == "aba84");
  if (!listed) {
    unknown_ = "method \"" + method_ + "\" is unknown here";
    return;
  }
  taken_ = step_;
  if (free_) return;
  const std::size_t stride = 1 + states.size() / kMostLooks;
  for (std::size_t i = 0; i < states.size(); i += stride) {
    local_ = std::max(local_, ofOneStep(body, states[i]->time, phaseOf(body, *states[i])));
  }
  if (local_ < kTooCoarse) {
    accuracy_ = std::numeric_limits<double>::quiet_NaN();  // not needed
  } else if (!std::isfinite(accuracy_)) {
    unknown_ = methodAndStep() + " is too coarse to be held to a bound of its own";
  }
}

/** Returns the error of a step from a phase; notes in taken_ how far a Taylor method halves the step. */
double Bounds::ofOneStep(const RigidBody& body, double t, const Phase& p) {
  const int taylor = taylorOrder(method_);
  const int order = taylor > 0 ? taylor : method_ == "buss2" ? 2 : method_ == "rk4" ? 4 : 8;
  const std::vector<double> terms = body.taylorTerms(t, p, step_, order + 3);
  if (taylor > 0) {
    double shrink = 1;
    const auto last = [&](int k) { return terms[k] * std::pow(shrink, k); };
    while (last(order) + last(order - 1) > kHalvedAt && shrink > 1e-6) shrink *= 0.5;
    taken_ = std::min(taken_, step_ * shrink);
    return remainder(terms, order, shrink);
  }
  const double r = pace(terms);
  if (method_ != "aba84") return kStep * std::pow(r, order + 1);
  // Kicks of relative strength s: O(s h⁸ + s² h⁴), and the free motion between them of order 8.
  const double speed = body.speed(t, p);
  const double strength = speed > 0 ? body.torqueScale(t, p) / (inertia_.moments[0] * speed * speed) : 0;
  return kFree8 * std::pow(r, 9) + kStep * strength * strength * std::pow(r, 5);
}

std::string Bounds::methodAndStep() const {
  return "method " + method_ + (step_ > 0 ? text(" at step %g s", step_) : "");
}

double Bounds::stepsIn(double duration) const {
  if (exact() || !(taken_ > 0)) return 0;
  // Both ends may lie between grid points: a partial step each.
  return std::abs(duration) / taken_ + (free_ ? 0 : 2 * step_ / taken_);
}

double Bounds::rounding(double duration) const {
  const double steps = stepsIn(duration);
  // A random walk, and a part of the rounding of a step that always has the same sign.
  return 1e-15 * std::sqrt(steps) + 5e-17 * steps;
}

double Bounds::ofSteps(double duration, double speed) const {
  const double turn = speed * std::abs(duration);
  if (!unknown_.empty()) return kUnknown * turn;
  return std::isfinite(accuracy_) ? kAccuracy * accuracy_ * (1 + turn) : stepsIn(duration) * local_;
}

double Bounds::ofFreeMotion(const Eigen::Vector3d& omega, double duration, double t) const {
  const double w = inertia_.fastestRate(omega), turn = w * std::abs(duration);
  const double parting = std::exp(std::min(50.0, inertia_.partingRate(omega) * std::abs(duration)));
  const double steps = exact() ? 0 : kFreeStep * std::pow(w * step_, row_.order) * (turn + 2 * w * step_);
  // The rounding of t, too, turns the body.
  return parting * (2e-14 + rounding(duration) + 1e-15 * w * std::abs(t) + steps);
}

double Bounds::allowed(const State& a, double speed, double duration) const {
  if (!free_ || !unknown_.empty()) return ofSteps(duration, speed);
  return ofFreeMotion(a.omega_body, duration, std::max(std::abs(a.time), std::abs(a.time + duration)));
}

double Bounds::kept(double condition, bool keeps, const State& s) const {
  if (!unknown_.empty()) return std::numeric_limits<double>::infinity();
  const double w = inertia_.fastestRate(s.omega_body);
  return condition * (2e-14 + rounding(s.time)) +
         (keeps ? 0 : row_.constant * std::pow(w * step_, row_.order) * (1 + w * std::abs(s.time)));
}

double Bounds::drift(double t, double speed) const {
  return 2e-14 + rounding(t) + ofSteps(t, speed);
}

double Bounds::attitude(const State& s) const {
  if (exact()) return kSameAttitude;
  if (!unknown_.empty()) return kPi;
  // The error is 0 at the start; one of the rate adds up from then on.
  const double turn = inertia_.fastestRate(s.omega_body) * std::abs(s.time);
  return std::min(kPi, ofFreeMotion(s.omega_body, s.time, s.time) * (1 + turn) + 4 * kSameAttitude);
}

}  // namespace poinsot::audit
