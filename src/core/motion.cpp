#include "poinsot/core/motion.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "poinsot/core/rotation.h"

namespace poinsot {
namespace {

constexpr double kLargestGridIndex = 9007199254740992.0;  // 2^53: beyond it t/h no longer tells two steps apart

MotionSetup checked(MotionSetup setup) {
  if (setup.method == kClosedForm) {
    if (setup.step) throw std::invalid_argument("the closed form takes no step");
  } else if (!findMethod(setup.method)) {
    throw std::invalid_argument("method \"" + setup.method + "\" is not one of " + kClosedForm + ", " + methodNames());
  } else if (!setup.step || !(*setup.step > 0) || !std::isfinite(*setup.step)) {
    throw std::invalid_argument("a stepper needs a step that is positive and finite");
  }
  if (!setup.omega_body.allFinite()) throw std::invalid_argument("angular velocity must be finite");
  if (const std::string problem = outOfRange(setup.inertia, setup.omega_body); !problem.empty()) {
    throw std::invalid_argument(problem);
  }
  const double norm = setup.attitude.coeffs().stableNorm();
  if (!(norm > 0) || !std::isfinite(norm)) throw std::invalid_argument("attitude must be a quaternion other than zero");
  setup.attitude.coeffs() /= norm;
  renormalise(setup.attitude);
  return setup;
}

bool principalAxesAreBodyAxes(const MotionSetup& setup) {
  return setup.inertia.axes().vec().isZero(0);
}

Eigen::Quaterniond principalAttitude(const MotionSetup& setup) {
  return principalAxesAreBodyAxes(setup) ? setup.attitude : setup.attitude * setup.inertia.axes();
}

Eigen::Vector3d principalOmega(const PrincipalInertia& inertia, const Eigen::Vector3d& omega_body) {
  return inertia.axes().conjugate() * omega_body;
}

StepperTrajectory trajectory(const MotionSetup& setup, double step) {
  const Eigen::Vector3d& moments = setup.inertia.moments();
  return {findMethod(setup.method)->make(moments),
          RotationState::fromOmega(moments, principalAttitude(setup), principalOmega(setup.inertia, setup.omega_body)),
          step};
}

}  // namespace

std::string outOfRange(const PrincipalInertia& inertia, const Eigen::Vector3d& omega_body) {
  if (omega_body.isZero(0)) return "";
  const Invariants invariants = invariantsOf(
      inertia.moments(),
      RotationState::fromOmega(inertia.moments(), Eigen::Quaterniond::Identity(), principalOmega(inertia, omega_body)));
  const auto problem = [](const char* what, double value) -> std::string {
    if (!std::isfinite(value)) return std::string(what) + " is not finite in double precision";
    const bool small = value < std::numeric_limits<double>::min();
    return small ? std::string(what) + " is too small for double precision (below 2.3e-308)" : "";
  };
  const std::string energy = problem("the kinetic energy", invariants.kinetic_energy);
  return !energy.empty() ? energy : problem("the squared angular momentum", invariants.momentum_squared);
}

Motion::Grid::Grid(const MotionSetup& setup)
    : step(*setup.step), forwards(trajectory(setup, step)), backwards(trajectory(setup, -step)) {}

Motion::Place Motion::Grid::locate(double t) const {
  const double distance = std::abs(t);
  const double n = std::floor(distance / step);
  if (!(n < kLargestGridIndex)) throw std::out_of_range("time is not finite, or too far for steps this short");
  const double rest = std::max(0.0, std::fma(-n, step, distance));
  return {static_cast<std::int64_t>(n), std::copysign(rest, t)};
}

double Motion::Grid::stepsTo(double t) const {
  if (!(std::abs(t) / step < kLargestGridIndex)) return std::numeric_limits<double>::infinity();
  return static_cast<double>(towards(t).stepsTo(locate(t).n));
}

RotationState Motion::Grid::at(double t) {
  const Place place = locate(t);
  StepperTrajectory& grid = towards(t);
  RotationState state = grid.at(place.n);
  if (place.remainder != 0) grid.stepper().advance(state, place.remainder, 1);
  return state;
}

Motion::Motion(const MotionSetup& setup)
    : setup_(checked(setup)),
      principal_axes_are_body_axes_(principalAxesAreBodyAxes(setup_)),
      exact_(setup_.inertia.moments(), principalAttitude(setup_), principalOmega(setup_.inertia, setup_.omega_body)) {
  if (setup_.method != kClosedForm) grid_.emplace(setup_);
}

double Motion::stepsTo(double t) const {
  if (grid_) return grid_->stepsTo(t);
  return std::isfinite(t) ? 0 : std::numeric_limits<double>::infinity();
}

bool Motion::prepare(double t, const std::atomic<bool>& cancel) {
  if (grid_) return grid_->towards(t).moveTo(grid_->locate(t).n, cancel);
  if (!std::isfinite(t)) throw std::out_of_range("time is not finite");
  return true;
}

bool Motion::conservesMomentum() const {
  return !grid_ || findMethod(setup_.method)->conserves_momentum;
}

double Motion::attitudeError(const MotionState& state) const {
  if (!grid_) return 0;
  const Eigen::Quaterniond exact = exact_.at(state.time).attitude;
  return angleBetween(state.attitude,
                      principal_axes_are_body_axes_ ? exact : exact * setup_.inertia.axes().conjugate());
}

MotionState Motion::at(double t) {
  const Eigen::Vector3d& moments = setup_.inertia.moments();
  if (grid_) {
    const RotationState state = grid_->at(t);
    return describe(t, state, state.omegaBody(moments));
  }
  if (!std::isfinite(t)) throw std::out_of_range("time is not finite");
  const ClosedForm::State state = exact_.at(t);
  return describe(t, RotationState::fromOmega(moments, state.attitude, state.omega_body), state.omega_body);
}

MotionState Motion::describe(double t, const RotationState& principal, const Eigen::Vector3d& omega) const {
  MotionState out;
  out.time = t;
  if (principal_axes_are_body_axes_) {
    out.attitude = principal.attitude;
    out.omega_body = omega;
  } else {
    out.attitude = principal.attitude * setup_.inertia.axes().conjugate();
    renormalise(out.attitude);
    out.omega_body = setup_.inertia.axes() * omega;
  }
  out.omega_world = principal.attitude * omega;
  const Invariants invariants = invariantsOf(setup_.inertia.moments(), principal);
  out.momentum_world = invariants.momentum_world;
  out.kinetic_energy = invariants.kinetic_energy;
  if (setup_.translation) {
    out.position = setup_.translation->positionAt(t);
    out.velocity = setup_.translation->velocityAt(t);
  }
  const bool rotation_is_finite = out.attitude.coeffs().allFinite() && out.omega_body.allFinite() &&
                                  out.omega_world.allFinite() && std::isfinite(out.kinetic_energy) &&
                                  std::isfinite(invariants.momentum_squared);
  if (!rotation_is_finite || !out.position.allFinite() || !out.velocity.allFinite()) {
    throw std::range_error(std::string(rotation_is_finite ? "the position or velocity" : "the rotation") +
                           " has left the range of doubles");
  }
  return out;
}

}  // namespace poinsot
