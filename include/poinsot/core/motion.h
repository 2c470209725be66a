#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "poinsot/core/closed_form.h"
#include "poinsot/core/effects/translation.h"
#include "poinsot/core/inertia.h"
#include "poinsot/core/invariants.h"
#include "poinsot/core/stepper_trajectory.h"

namespace poinsot {

/** A body's motion at one time, in the body axes in which its inertia was given (not the principal axes). */
struct MotionState {
  double time = 0;                                               ///< [s]
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< R: body → world, unit
  Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();          ///< Ω [rad/s]
  Eigen::Vector3d omega_world = Eigen::Vector3d::Zero();         ///< ω = RΩ [rad/s]
  Eigen::Vector3d momentum_world = Eigen::Vector3d::Zero();      ///< L [kg·m²/s]
  double kinetic_energy = 0;                                     ///< E = ½ΩᵀMΩ [J]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();            ///< [m], world axes
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();            ///< [m/s], world axes

  Invariants invariants() const { return {kinetic_energy, momentum_world.squaredNorm(), momentum_world}; }
};

/** What a motion is made of. */
struct MotionSetup {
  PrincipalInertia inertia = PrincipalInertia::fromMoments({1, 1, 1});
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< at t = 0, body → world; normalised on use
  Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();          ///< at t = 0 [rad/s], body axes
  std::string method = kClosedForm;
  std::optional<double> step;              ///< [s]; a stepper needs one, the closed form has none
  std::optional<Translation> translation;  ///< not computed where absent
};

/**
 * Why no motion begins like this, or nothing: E or F = |L|² is beyond the range of doubles, or, of a body that turns,
 * too small to be held in full precision. A free body keeps both, so that what holds at the start holds for ever.
 */
std::string outOfRange(const PrincipalInertia& inertia, const Eigen::Vector3d& omega_body);

/**
 * One body in motion: its method and the effects that act on it, composed. A copy is independent.
 *
 * The state at t depends on t alone: the closed form is a function of t; a stepper lives on the grid n·h from t = 0,
 * and the rest of the way to t is a partial step that is thrown away.
 */
class Motion {
 public:
  /**
   * Throws std::invalid_argument for an unknown method, a stepper without a step that is positive and finite, a closed
   * form with a step, a zero attitude, an angular velocity that is not finite or outOfRange().
   */
  explicit Motion(const MotionSetup& setup);

  /**
   * The state at t [s] of either sign: in constant time in closed form, else after as many steps as are needed. Throws
   * - std::out_of_range where stepsTo(t) is infinite (t not finite, or 2⁵³ steps away), like prepare();
   * - std::range_error where the state has left the range of doubles: no state is returned that is not finite;
   * - NoConvergence where an implicit method does not get there.
   */
  MotionState at(double t);

  /** How many steps at(t) would take now: 0 in closed form. Infinite where at(t) would throw std::out_of_range. */
  double stepsTo(double t) const;

  /** Does the stepping that at(t) needs; false when `cancel` became true first. */
  bool prepare(double t, const std::atomic<bool>& cancel);

  bool inClosedForm() const { return !grid_; }

  /** True when the method keeps L in world axes, to roundoff. */
  bool conservesMomentum() const;

  /** How far a state of this motion is from the closed form at the same t [rad]: 0 for the closed form itself. */
  double attitudeError(const MotionState& state) const;

  const MotionSetup& setup() const { return setup_; }

 private:
  struct Place {
    std::int64_t n;    ///< whole steps from t = 0
    double remainder;  ///< seconds beyond them, with t's sign
  };
  /** What a stepper needs. */
  struct Grid {
    double step;
    StepperTrajectory forwards, backwards;

    explicit Grid(const MotionSetup& setup);
    Place locate(double t) const;
    double stepsTo(double t) const;
    RotationState at(double t);
    StepperTrajectory& towards(double t) { return t < 0 ? backwards : forwards; }
    const StepperTrajectory& towards(double t) const { return t < 0 ? backwards : forwards; }
  };

  MotionState describe(double t, const RotationState& principal, const Eigen::Vector3d& omega) const;

  MotionSetup setup_;
  bool principal_axes_are_body_axes_;
  ClosedForm exact_;          ///< the motion itself, or what a stepper is compared with; principal axes
  std::optional<Grid> grid_;  ///< of a stepper
};

}  // namespace poinsot
