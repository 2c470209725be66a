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

  /** Returns E, F and L of this state. */
  Invariants invariants() const;
};

/** The body, its start, its method and the effects on it, from which a Motion is made. */
struct MotionSetup {
  /** The inertia about the centre of mass, or about the pivot of a body that has one. */
  PrincipalInertia inertia = PrincipalInertia::fromMoments({1, 1, 1});
  Quaternion attitude = Quaternion::Identity();          ///< at t = 0, body → world; normalised on use
  Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();  ///< at t = 0 [rad/s], body axes
  std::string method = kClosedForm;                      ///< kClosedForm, or a name of methods()
  std::optional<double> step;                            ///< [s]; needed for a stepper, not allowed for the closed form
  std::optional<Translation> translation;                ///< position and velocity stay 0 without it
  std::vector<Effect> effects;                           ///< of torques; empty for a free body
};

/**
 * Returns why no motion can begin with this angular velocity [rad/s, body axes]; empty where one can. The reason is
 * that E or F = |L|² is beyond the range of doubles, or, for a body that turns, too small to be held in full precision.
 * A free body keeps both, so it is enough to look at the start.
 */
std::string outOfRange(const PrincipalInertia& inertia, const Eigen::Vector3d& omega_body);

/**
 * One body in motion, under its method and the effects on it. A copy is independent.
 *
 * The state at t depends on t alone: the closed form is a function of t; a stepper goes along the grid n·h from t = 0,
 * and a partial step from there to t changes nothing on the grid.
 */
class Motion {
 public:
  /**
   * Throws std::invalid_argument for an unknown method, a stepper without a positive finite step, a closed form with a
   * step or with effects, a method that does not take these effects, effects that exclude each other, an attitude that
   * is zero or not finite, and an angular velocity that is not finite or outOfRange().
   */
  explicit Motion(const MotionSetup& setup);

  /**
   * Returns the state at t [s], of either sign: in constant time in closed form, else after stepsTo(t) steps. Throws
   * - std::out_of_range where stepsTo(t) is infinite (t not finite, or 2⁵³ steps away), like prepare();
   * - std::range_error where the state has left the range of doubles: no state is returned that is not finite;
   * - NoConvergence where an implicit method finds no solution of a step.
   */
  MotionState at(double t);

  /** Returns how many steps at(t) would take now: 0 in closed form, infinite where it would throw std::out_of_range. */
  double stepsTo(double t) const;

  /** Takes the steps that at(t) needs. Returns false when `cancel` became true first. */
  bool prepare(double t, const std::atomic<bool>& cancel);

  /** Returns whether the body moves in closed form, without a stepper. */
  bool inClosedForm() const { return !grid_; }

  /** Returns the torques on the body; nullptr for a free one. */
  const Torques* torques() const { return torques_ ? &*torques_ : nullptr; }

  /** Returns the work of all whole steps so far; none in closed form. */
  Work work() const;

  /** Returns whether L in world axes is constant to roundoff: for a free body under a method that keeps it. */
  bool conservesMomentum() const;

  /**
   * Returns the angle between a state of this motion and the closed form at the same t [rad]: 0 for the closed form
   * itself, NaN under torques, where there is no closed form.
   */
  double attitudeError(const MotionState& state) const;

  /** Returns the closed form of a free body, whatever its method, in principal axes; nullptr under torques. */
  const ClosedForm* closedForm() const { return exact_ ? &*exact_ : nullptr; }

  /** Returns the setup that the motion was made from, its attitude normalised. */
  const MotionSetup& setup() const { return setup_; }

 private:
  struct Place {
    std::int64_t n;    ///< whole steps from t = 0
    double remainder;  ///< seconds beyond them, with t's sign
  };
  /** The grids of a stepper, forwards and backwards from t = 0. */
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
  std::optional<ClosedForm> exact_;  ///< of a free body, in principal axes; its stepper is compared with it
  std::optional<Grid> grid_;         ///< of a body that a stepper moves
};

}  // namespace poinsot
