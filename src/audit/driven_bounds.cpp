#include "poinsot/audit/driven_bounds.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace poinsot::audit {
namespace {

constexpr double kLocal = 2;        // C of C r^(p+1), r as in pace()
constexpr double kFree8 = 1e-6;     // of aba84's free motion
constexpr double kSafety = 4;       // on what a Taylor series leaves out
constexpr double kHalvedAt = 1e-2;  // Taylor methods halve steps whose last two terms are larger
constexpr int kMostLooks = 500;     // at a motion's Taylor series
constexpr double kTooVague = 1e-2;
constexpr double kAccuracy = 4;    // of an accuracy that was asked for
constexpr double kUnknown = 1e-3;  // of the turn

/** The order in "taylor16", or 0. */
int taylorOrder(const std::string& method) {
  if (method.compare(0, 6, "taylor") != 0) return 0;
  const int order = std::atoi(method.c_str() + 6);
  return order >= 2 && order <= 24 ? order : 0;
}

/** What a Taylor step leaves out: the next two terms, and the geometric series behind them. */
double remainder(const std::vector<double>& terms, int order, double shrink) {
  const double a = terms[order + 1] * std::pow(shrink, order + 1), b = terms[order + 2] * std::pow(shrink, order + 2);
  const double ratio = std::max(std::pow(a, 1.0 / (order + 1)), std::pow(b, 1.0 / (order + 2)));
  return kSafety * (a + b) / (1 - std::min(ratio, 0.9));
}

/** How far a motion goes in a step, as all its derivatives see it: max (|aₖ|hᵏ)^(1/k), k ≥ 1. */
double pace(const std::vector<double>& terms) {
  double r = 0;
  for (std::size_t k = 1; k < terms.size(); ++k) r = std::max(r, std::pow(terms[k], 1.0 / static_cast<double>(k)));
  return r;
}

}  // namespace

Phase phaseOf(const DrivenBody& body, const State& s) {
  Phase p{s.attitude, s.omega_body};
  if (const auto& slug = body.effects().slug) {
    p.slug_omega = (s.attitude.conjugate() * s.momentum_world - body.inertia().tensor * s.omega_body) / slug->inertia;
  }
  return p;
}

DrivenBounds::DrivenBounds(const Description& description, const DrivenBody& body,
                           const std::vector<const State*>& states)
    : method_(description.method), step_(description.step) {
  if (!(step_ > 0) || !std::isfinite(step_)) return;
  const int order = taylorOrder(method_);
  if (order == 0 && method_ != "rk4" && method_ != "buss2" && method_ != "aba84") return;
  const std::size_t stride = 1 + states.size() / kMostLooks;
  double largest_shrink = 1;
  for (std::size_t i = 0; i < states.size(); i += stride) {
    const double t = states[i]->time;
    const Phase p = phaseOf(body, *states[i]);
    const int low = method_ == "buss2" ? 2 : method_ == "rk4" ? 4 : 8;  // of the free motion
    const std::vector<double> terms = body.taylorTerms(t, p, step_, (order > 0 ? order : low) + 3);
    double error = 0;
    if (order > 0) {
      double shrink = 1;
      const auto last = [&](int k) { return terms[k] * std::pow(shrink, k); };
      while (last(order) + last(order - 1) > kHalvedAt && shrink > 1e-6) shrink *= 0.5;
      error = remainder(terms, order, shrink);
      largest_shrink = std::min(largest_shrink, shrink);
    } else if (method_ == "aba84") {
      // Kicks of relative strength s: O(s h⁸ + s² h⁴), and the free motion between them of order 8.
      const double speed = body.speed(t, p);
      const double strength = speed > 0 ? body.torqueScale(t, p) / (body.inertia().moments[0] * speed * speed) : 0;
      const double r = pace(terms);
      error = kFree8 * std::pow(r, 9) + kLocal * strength * strength * std::pow(r, 5);
    } else {
      error = kLocal * std::pow(pace(terms), low + 1);
    }
    local_ = std::max(local_, error);
  }
  taken_ = step_ * largest_shrink;
  by_ = local_ < kTooVague ? By::steps : std::isfinite(description.accuracy) ? By::accuracy : By::nothing;
  accuracy_ = description.accuracy;
  too_coarse_ = by_ == By::nothing;
}

double DrivenBounds::allowed(double duration, double speed) const {
  const double turn = speed * std::abs(duration);
  if (by_ == By::steps) return steps(duration) * local_;
  return by_ == By::accuracy ? kAccuracy * accuracy_ * (1 + turn) : kUnknown * turn;
}

double DrivenBounds::steps(double duration) const {
  return taken_ > 0 ? std::abs(duration) / taken_ + 2 * step_ / taken_ : 0;
}

double DrivenBounds::drift(double t, double speed) const {
  const double n = steps(t);
  return 1e-15 * (20 + std::sqrt(n)) + 5e-17 * n + allowed(t, speed);
}

}  // namespace poinsot::audit
