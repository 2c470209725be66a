#include "poinsot/core/motion.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "poinsot/core/rotation.h"

namespace poinsot {
namespace {

constexpr double kLargestGridIndex = 9007199254740992.0;  // 2^53: beyond it t/h no longer tells two steps apart

MotionSetup checked(MotionSetup setup) {
  if (!findMethod(setup.method)) {
    throw std::invalid_argument("method \"" + setup.method + "\" is not one of " + methodNames());
  }
  if (!(setup.step > 0) || !std::isfinite(setup.step)) throw std::invalid_argument("step must be positive and finite");
  if (!setup.omega_body.allFinite()) throw std::invalid_argument("angular velocity must be finite");
  const double norm = setup.attitude.coeffs().stableNorm();
  if (!(norm > 0) || !std::isfinite(norm)) throw std::invalid_argument("attitude must be a quaternion other than zero");
  setup.attitude.coeffs() /= norm;
  renormalise(setup.attitude);
  return setup;
}

RotationState principalStart(const MotionSetup& setup) {
  const Eigen::Quaterniond& axes = setup.inertia.axes();
  return RotationState::fromOmega(setup.inertia.moments(), setup.attitude * axes, axes.conjugate() * setup.omega_body);
}

StepperTrajectory trajectory(const MotionSetup& setup, double step) {
  return {findMethod(setup.method)->make(setup.inertia.moments()), principalStart(setup), step};
}

}  // namespace

Motion::Motion(const MotionSetup& setup)
    : setup_(checked(setup)),
      principal_axes_are_body_axes_(setup_.inertia.axes().vec().isZero(0)),
      forwards_(trajectory(setup_, setup_.step)),
      backwards_(trajectory(setup_, -setup_.step)) {}

Motion::Place Motion::locate(double t) const {
  const double distance = std::abs(t);
  const double n = std::floor(distance / setup_.step);
  if (!(n < kLargestGridIndex)) throw std::out_of_range("time is not finite, or too far for steps this short");
  const double rest = std::max(0.0, std::fma(-n, setup_.step, distance));
  return {static_cast<std::int64_t>(n), std::copysign(rest, t)};
}

double Motion::stepsTo(double t) const {
  if (!(std::abs(t) / setup_.step < kLargestGridIndex)) return std::numeric_limits<double>::infinity();
  return static_cast<double>((t < 0 ? backwards_ : forwards_).stepsTo(locate(t).n));
}

bool Motion::prepare(double t, const std::atomic<bool>& cancel) {
  return (t < 0 ? backwards_ : forwards_).moveTo(locate(t).n, cancel);
}

MotionState Motion::at(double t) {
  const Place place = locate(t);
  StepperTrajectory& grid = t < 0 ? backwards_ : forwards_;
  RotationState state = grid.at(place.n);
  if (place.remainder != 0) grid.stepper().advance(state, place.remainder, 1);
  return describe(t, state);
}

MotionState Motion::describe(double t, const RotationState& principal) const {
  MotionState out;
  out.time = t;
  const Eigen::Vector3d omega = principal.omegaBody(setup_.inertia.moments());
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
  return out;
}

}  // namespace poinsot
