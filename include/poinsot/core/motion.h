#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

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

/** What a body gets that names no method. */
constexpr const char* kDefaultMethod = "buss2";
constexpr double kDefaultStep = 1e-4;  // s

/** What a motion is made of. */
struct MotionSetup {
  PrincipalInertia inertia = PrincipalInertia::fromMoments({1, 1, 1});
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< at t = 0, body → world; normalised on use
  Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();          ///< at t = 0 [rad/s], body axes
  std::string method = kDefaultMethod;
  double step = kDefaultStep;              ///< [s]
  std::optional<Translation> translation;  ///< not computed where absent
};

/**
 * One body in motion: its method and the effects that act on it, composed. A copy is independent.
 *
 * The state at t depends on t alone: a stepper lives on the grid n·h from t = 0, and the rest of the way to t is a
 * partial step that is thrown away.
 */
class Motion {
 public:
  /**
   * Throws std::invalid_argument for an unknown method, a step that is not positive and finite, a zero attitude, an
   * angular velocity that is not finite.
   */
  explicit Motion(const MotionSetup& setup);

  /**
   * The state at t [s] of either sign. Steps as far as needed. Throws std::out_of_range where stepsTo(t) is infinite
   * (t not finite, or 2⁵³ steps away), like prepare().
   */
  MotionState at(double t);

  /** How many steps at(t) would take now. Infinite where the grid index would not fit. */
  double stepsTo(double t) const;

  /** Does the stepping that at(t) needs; false when `cancel` became true first. */
  bool prepare(double t, const std::atomic<bool>& cancel);

  const MotionSetup& setup() const { return setup_; }

 private:
  struct Place {
    std::int64_t n;    ///< whole steps from t = 0
    double remainder;  ///< seconds beyond them, with t's sign
  };
  Place locate(double t) const;
  MotionState describe(double t, const RotationState& principal) const;

  MotionSetup setup_;
  bool principal_axes_are_body_axes_;
  StepperTrajectory forwards_, backwards_;
};

}  // namespace poinsot
