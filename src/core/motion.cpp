#include "poinsot/core/motion.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "half_turn.h"
#include "poinsot/core/method.h"
#include "poinsot/core/number_text.h"
#include "poinsot/core/rotation.h"
#include "refuse.h"

namespace poinsot {
namespace {

constexpr double kLargestGridIndex = 9007199254740992.0;  // 2^53: beyond it t/h no longer tells two steps apart

void checkMethod(const MotionSetup& setup) {
  const bool torqued = !setup.effects.empty();
  const std::vector<Method>& list = torqued ? torquedMethods() : freeMethods();
  const std::string expected = "expected one of " + std::string(torqued ? "" : "closed_form, ") + methodNames(list);
  const std::string got = ", got \"" + setup.method + "\"";
  if (setup.method == kClosedForm) {
    if (torqued) {
      refuse(expected + got + ", the motion of a free body: " + nameOf(setup.effects.front()) + " acts on this one");
    }
    if (setup.step) refuse("expected no step for closed_form, got " + numberText(*setup.step) + " s");
    return;
  }
  const Method* method = findMethod(setup.method, list);
  if (!method) {
    const char* kind = torqued ? ", which takes no torques" : ", which moves only bodies with effects";
    refuse(expected + got + (findMethod(setup.method) ? kind : ""));
  }
  const std::string objection = torqued ? objectionTo(*method, sumOf(setup.inertia, setup.effects)) : "";
  if (!objection.empty()) refuse(objection);
  if (!setup.step) refuse("expected a step (s) for " + setup.method + ", got none");
  requirePositive(*setup.step, "step", "s");
}

MotionSetup checked(MotionSetup setup) {
  checkMethod(setup);
  requireFinite(setup.omega_body);
  if (const std::string problem = outOfRange(setup.inertia, setup.omega_body); !problem.empty()) refuse(problem);
  const double norm = setup.attitude.coeffs().stableNorm();
  if (!(norm > 0) || !std::isfinite(norm)) refuseAttitude(setup.attitude);
  setup.attitude.coeffs() /= norm;
  renormalise(setup.attitude);
  return setup;
}

void requireFiniteTime(double t) {
  if (!std::isfinite(t)) throw std::out_of_range("expected a finite time (s), got " + numberText(t, 17));
}

bool principalAxesAreBodyAxes(const MotionSetup& setup) {
  return setup.inertia.axes().vec().isZero(0);
}

Quaternion principalAttitude(const MotionSetup& setup) {
  return principalAxesAreBodyAxes(setup) ? setup.attitude : Quaternion(setup.attitude * setup.inertia.axes());
}

/** Returns the state at t = 0. A slug starts with the angular velocity of the body. */
RotationState startOf(const MotionSetup& setup, bool with_slug) {
  const Eigen::Vector3d omega_principal = setup.inertia.toPrincipal(setup.omega_body);
  RotationState start = RotationState::fromOmega(setup.inertia.moments(), principalAttitude(setup), omega_principal);
  if (with_slug) start.slug_omega = omega_principal;
  return start;
}

}  // namespace

Invariants MotionState::invariants() const {
  return {kinetic_energy, momentum_world.squaredNorm(), momentum_world};
}

std::string outOfRange(const PrincipalInertia& inertia, const Eigen::Vector3d& omega_body) {
  if (omega_body.isZero(0)) return "";
  const Invariants invariants = invariantsOf(
      inertia.moments(),
      RotationState::fromOmega(inertia.moments(), Eigen::Quaterniond::Identity(), inertia.toPrincipal(omega_body)));
  const auto problem = [](const char* what, double value) -> std::string {
    if (!std::isfinite(value)) return std::string(what) + " is not finite in double precision";
    const bool small = value < std::numeric_limits<double>::min();
    return small ? std::string(what) + " is too small for double precision (below 2.3e-308)" : "";
  };
  const std::string energy = problem("the kinetic energy", invariants.kinetic_energy);
  return !energy.empty() ? energy : problem("the squared angular momentum", invariants.momentum_squared);
}

Motion::Place Motion::Grid::locate(double t) const {
  const double distance = std::abs(t);
  const double n = std::floor(distance / step);
  if (!(n < kLargestGridIndex)) {
    throw std::out_of_range("expected a finite time less than 2^53 steps of " + numberText(step) +
                            " s from t = 0, got t = " + numberText(t, 17) + " s");
  }
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
  if (place.remainder != 0) {
    grid.stepper().advanceFrom(state, std::copysign(static_cast<double>(place.n) * step, t), place.remainder);
  }
  return state;
}

Motion::Motion(const MotionSetup& setup)
    : setup_(checked(setup)), principal_axes_are_body_axes_(principalAxesAreBodyAxes(setup_)) {
  const Method* method = findMethod(setup_.method);
  if (!setup_.effects.empty()) {
    torques_ = sumOf(setup_.inertia, setup_.effects);
    grid_.emplace(method->make(*torques_), startOf(setup_, torques_->slug().has_value()), *setup_.step);
    return;
  }
  exact_.emplace(setup_.inertia.moments(), principalAttitude(setup_), setup_.inertia.toPrincipal(setup_.omega_body));
  if (method) grid_.emplace(method->make(setup_.inertia.moments()), startOf(setup_, false), *setup_.step);
}

double Motion::stepsTo(double t) const {
  if (grid_) return grid_->stepsTo(t);
  return std::isfinite(t) ? 0 : std::numeric_limits<double>::infinity();
}

bool Motion::prepare(double t, const std::atomic<bool>& cancel) {
  if (grid_) return grid_->prepare(t, cancel);
  requireFiniteTime(t);
  return true;
}

Work Motion::work() const {
  Work work;
  if (grid_) (work += grid_->forwards.work()) += grid_->backwards.work();
  return work;
}

bool Motion::conservesMomentum() const {
  return !torques_ && (!grid_ || findMethod(setup_.method)->conserves_momentum);
}

double Motion::attitudeError(const MotionState& state) const {
  if (torques_) return std::numeric_limits<double>::quiet_NaN();
  if (!grid_) return 0;
  const Quaternion exact = exact_->at(state.time).attitude;
  return angleBetween(state.attitude,
                      principal_axes_are_body_axes_ ? exact : Quaternion(exact * setup_.inertia.axes().conjugate()));
}

MotionState Motion::at(double t) {
  const Eigen::Vector3d& moments = setup_.inertia.moments();
  if (grid_) {
    const RotationState state = grid_->at(t);
    MotionState out = describe(t, state, state.omegaPrincipal(moments));
    if (torques_) describeTorques(state, out);
    return out;
  }
  requireFiniteTime(t);
  const ClosedForm::State state = exact_->at(t);
  FreeRotationState principal;  // no stepper moves it, so it keeps no momentum
  principal.attitude = state.attitude;
  principal.momentum_principal = moments.cwiseProduct(state.omega_principal);
  return describe(t, principal, state.omega_principal);
}

void Motion::describeTorques(const RotationState& principal, MotionState& out) const {
  const Torques& torques = *torques_;
  const Torques::Constant& constant = torques.constant(torques.intervalAt(out.time));
  out.torque_world = principal.attitude * torques.at(out.time, constant, principal.attitude,
                                                     principal.omegaPrincipal(torques.moments()), principal.slug_omega);
  if (torques.slug()) {
    out.slug_omega = setup_.inertia.toBody(principal.slug_omega);
    out.momentum_world += principal.attitude * (torques.slug()->inertia * principal.slug_omega);
  }
  if (!out.torque_world.allFinite() || !out.slug_omega.allFinite() || !out.momentum_world.allFinite()) {
    throw std::range_error("the torque or the slug's rotation has left the range of doubles");
  }
}

MotionState Motion::describe(double t, const FreeRotationState& principal, const Eigen::Vector3d& omega) const {
  MotionState out;
  out.time = t;
  if (principal_axes_are_body_axes_) {
    out.attitude = principal.attitude;
    out.omega_body = omega;
  } else {
    out.attitude = principal.attitude * setup_.inertia.axes().conjugate();
    renormalise(out.attitude);
    out.omega_body = setup_.inertia.toBody(omega);
  }
  out.omega_world = principal.attitude * omega;
  const Invariants invariants = invariantsOf(setup_.inertia.moments(), principal);
  out.momentum_world = invariants.momentum_world;
  out.kinetic_energy = invariants.kinetic_energy;
  bool place_is_finite = true;
  if (setup_.translation) {
    out.position = setup_.translation->positionAt(t);
    out.velocity = setup_.translation->velocityAt(t);
    place_is_finite = out.position.allFinite() && out.velocity.allFinite();
  }
  const bool rotation_is_finite = out.attitude.coeffs().allFinite() && out.omega_body.allFinite() &&
                                  out.omega_world.allFinite() && std::isfinite(out.kinetic_energy) &&
                                  std::isfinite(invariants.momentum_squared);
  if (!rotation_is_finite || !place_is_finite) {
    throw std::range_error(std::string(rotation_is_finite ? "the position or velocity" : "the rotation") +
                           " has left the range of doubles" +
                           (torques_ ? ", or moves faster than such steps can follow" : ""));
  }
  return out;
}

}  // namespace poinsot
