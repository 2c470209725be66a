#include "poinsot/audit/method_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poinsot::audit {
namespace {

// How much an order allows: several times what random bodies show, so that no working method fails.
constexpr double kNotMeasured = 0.2, kLocal = 0.6;
constexpr double kPi = 3.14159265358979323846;
constexpr double kSameAttitude = 1e-15;  // rad: of the closed form against itself

struct Row {
  const char* name;
  int order;  ///< 0: exact
  bool conserves_momentum, conserves_energy;
  double constant;  ///< C, of what it does not conserve
};

constexpr Row kMethods[] = {
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

}  // namespace

MethodBounds::MethodBounds(const Description& description) : method_(description.method), step_(description.step) {
  for (const Row& row : kMethods) {
    if (method_ != row.name) continue;
    order_ = row.order;
    constant_ = row.constant;
    exact_ = row.order == 0;
    conserves_momentum_ = row.conserves_momentum;
    conserves_energy_ = row.conserves_energy;
    known_ = exact_ || (std::isfinite(step_) && step_ > 0);
  }
}

double MethodBounds::roundoff(double t) const {
  const double steps = exact_ || !(step_ > 0) ? 0 : std::abs(t) / step_;
  // A random walk, and the part of a step's rounding that always points the same way.
  return 1e-15 * (20 + std::sqrt(steps)) + 5e-17 * steps;
}

double MethodBounds::growth(const Inertia& inertia, const Eigen::Vector3d& omega_body, double t) const {
  if (!known_) return std::numeric_limits<double>::infinity();
  const double w = inertia.fastestRate(omega_body);
  return constant_ * std::pow(w * step_, order_) * (1 + w * std::abs(t));
}

double MethodBounds::energy(const Inertia& inertia, const Eigen::Vector3d& omega_body, double t) const {
  const double rounding = inertia.conditionOfEnergy(omega_body) * roundoff(t);
  return rounding + (known_ && conserves_energy_ ? 0 : growth(inertia, omega_body, t));
}

double MethodBounds::momentum(const Inertia& inertia, const Eigen::Vector3d& omega_body, double t) const {
  const double rounding = inertia.conditionOfMomentum(omega_body) * roundoff(t);
  return rounding + (known_ && conserves_momentum_ ? 0 : growth(inertia, omega_body, t));
}

double MethodBounds::local(const Inertia& inertia, const Eigen::Vector3d& omega_body, double duration, double t) const {
  if (!known_) return std::numeric_limits<double>::infinity();
  const double w = inertia.fastestRate(omega_body);
  const double parting = std::exp(std::min(50.0, inertia.partingRate(omega_body) * std::abs(duration)));
  // Both ends may lie between grid points: a partial step each, on top of the whole ones.
  const double steps = exact_ ? 0 : kLocal * std::pow(w * step_, order_) * (w * std::abs(duration) + 2 * w * step_);
  // t itself is rounded, and the phase that belongs to it.
  return parting * (roundoff(duration) + 1e-15 * w * std::abs(t) + steps);
}

double MethodBounds::attitude(const Inertia& inertia, const Eigen::Vector3d& omega_body, double t) const {
  if (exact_) return kSameAttitude;
  if (!known_) return kPi;
  // From the start, where it is exact; an error of the rate, once made, adds up.
  const double bound = local(inertia, omega_body, t, t) * (1 + inertia.fastestRate(omega_body) * std::abs(t));
  return std::min(kPi, bound + 4 * kSameAttitude);
}

}  // namespace poinsot::audit
