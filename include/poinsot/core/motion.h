#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/core/closed_form.h"
#include "poinsot/core/effect.h"
#include "poinsot/core/effects/translation.h"
#include "poinsot/core/eigen_types.h"
#include "poinsot/core/inertia.h"
#include "poinsot/core/invariants.h"
#include "poinsot/core/stepper_trajectory.h"
#include "poinsot/core/torques.h"

namespace poinsot {

/** A body's motion at one time, in the body axes in which its inertia was given (not the principal axes). */
struct MotionState {
  double time = 0;                                           ///< [s]
  Quaternion attitude = Quaternion::Identity();              ///< R: body → world, unit
  Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();      ///< Ω [rad/s]
  Eigen::Vector3d omega_world = Eigen::Vector3d::Zero();     ///< ω = RΩ [rad/s]
  Eigen::Vector3d momentum_world = Eigen::Vector3d::Zero();  ///< L [kg·m²/s]; of a body with a slug, both together
  double kinetic_energy = 0;                                 ///< E = ½ΩᵀMΩ [J]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();        ///< [m], world axes
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();        ///< [m/s], world axes
  Eigen::Vector3d torque_world = Eigen::Vector3d::Zero();    ///< all effects together [N·m]; zero for a free body
  Eigen::Vector3d slug_omega = Eigen::Vector3d::Zero();      ///< σ of a slug inside [rad/s], body axes

  /** E, F and L of this state. */
  Invariants invariants() const;
};

/** What a motion is made of. */
struct MotionSetup {
  /** About the centre of mass, or about the pivot of a body that has one. */
  PrincipalInertia inertia = PrincipalInertia::fromMoments({1, 1, 1});
  Quaternion attitude = Quaternion::Identity();          ///< at t = 0, body → world; normalised on use
  Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();  ///< at t = 0 [rad/s], body axes
  std::string method = kClosedForm;                      ///< kClosedForm, or a name of methods()
  std::optional<double> step;                            ///< [s]; a stepper needs one, the closed form has none
  std::optional<Translation> translation;                ///< not computed where absent
  std::vector<Effect> effects;                           ///< what turns it; a free body has none
};

/**
 * Why no motion can begin with this angular velocity [rad/s, body axes]; empty where one can. The reason is that E or F
 * = |L|² is beyond the range of doubles, or, for a body that turns, too small to be held in full precision. A free body
 * keeps both, so what holds at the start holds for ever.
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
   * form with a step or with effects, a method that does not take these effects, effects that do not go together, a
   * zero attitude, an angular velocity that is not finite or outOfRange().
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

  /** True when no stepper moves the body. */
  bool inClosedForm() const { return !grid_; }

  /** What turns the body; nullptr for a free one. */
  const Torques* torques() const { return torques_ ? &*torques_ : nullptr; }

  /** What all whole steps so far took; nothing in closed form. */
  Work work() const;

  /** True when L in world axes is constant to roundoff: a free body's, under a method that keeps it. */
  bool conservesMomentum() const;

  /**
   * How far a state of this motion is from the closed form at the same t [rad]: 0 for the closed form itself; NaN where
   * there is none, under torques.
   */
  double attitudeError(const MotionState& state) const;

  /** A free body's, whatever method moves it, in principal axes; nullptr under torques. */
  const ClosedForm* closedForm() const { return exact_ ? &*exact_ : nullptr; }

  /** What it was made of. */
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

    Grid(const std::shared_ptr<const Stepper>& stepper, const RotationState& start, double grid_step)
        : step(grid_step), forwards(stepper, start, grid_step), backwards(stepper, start, -grid_step) {}
    Place locate(double t) const;
    double stepsTo(double t) const;
    bool prepare(double t, const std::atomic<bool>& cancel) { return towards(t).moveTo(locate(t).n, cancel); }
    RotationState at(double t);
    StepperTrajectory& towards(double t) { return t < 0 ? backwards : forwards; }
    const StepperTrajectory& towards(double t) const { return t < 0 ? backwards : forwards; }
  };

  MotionState describe(double t, const FreeRotationState& principal, const Eigen::Vector3d& omega) const;
  void describeTorques(const RotationState& principal, MotionState& out) const;

  MotionSetup setup_;
  bool principal_axes_are_body_axes_;
  std::optional<Torques> torques_;   ///< of a body with effects
  std::optional<ClosedForm> exact_;  ///< of a free body, in principal axes; also what its stepper is compared with
  std::optional<Grid> grid_;         ///< what moves a body that is not moved in closed form
};

}  // namespace poinsot
