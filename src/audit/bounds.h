#pragma once

#include <string>
#include <vector>

#include "poinsot/audit/recording.h"
#include "rigid_body.h"

namespace poinsot::audit {

/** Returns the phase of the body in a state; σ of a slug follows from momentum_world: (RᵀL − MΩ)/J. */
Phase phaseOf(const RigidBody& body, const State& s);

/** A row of the audit's table of methods for free bodies. */
struct FreeMethod {
  const char* name = "";
  int order = -1;  ///< 0: exact; -1: not known
  bool keeps_momentum = false, keeps_energy = false;
  double constant = 0;  ///< C in the bound of what it does not keep
};

/**
 * Bounds of the errors that a motion may have under the method and step of its description. For free bodies they follow
 * from the audit's own table of methods: h is the step, p the order, w the fastest rate at the body's |L|. For bodies
 * under torques they follow from the Taylor series of the motion. doc/audit.md has the formulas.
 */
class Bounds {
 public:
  /** @param states of the motion: under torques, the error of a step differs between them. */
  Bounds(const Description& description, const RigidBody& body, const std::vector<const State*>& states);

  /** Returns why there is no bound for this method; empty where there is one. */
  const std::string& unknown() const { return unknown_; }
  bool exact() const { return row_.order == 0; }  ///< the closed form
  const std::string& method() const { return method_; }
  /** Returns "method rk4 at step 0.001 s". */
  std::string methodAndStep() const;

  /**
   * Returns the error that the method may make in a motion of that duration from `a` on: of the attitude [rad], and of
   * Ω and σ relative to the speed [rad/s]. For a body under torques, the growth of such errors comes on top.
   */
  double allowed(const State& a, double speed, double duration) const;

  /** Return the relative errors that E and L of a free body may have in a state; infinite for an unknown method. */
  double energy(const State& s) const { return kept(inertia_.conditionOfEnergy(s.omega_body), row_.keeps_energy, s); }
  double momentum(const State& s) const {
    return kept(inertia_.conditionOfMomentum(s.omega_body), row_.keeps_momentum, s);
  }
  /** Returns the error that the attitude of a free body may have [rad], at most π. */
  double attitude(const State& s) const;
  /** Returns the bound at t of the change since t = 0 of a constant of the motion under torques, in the measure of
   * allowed(). */
  double drift(double t, double speed) const;

  /** Returns the relative rounding error of the steps within a duration. */
  double rounding(double duration) const;

 private:
  double stepsIn(double duration) const;
  double ofSteps(double duration, double speed) const;
  double kept(double condition, bool keeps, const State& s) const;
  double ofFreeMotion(const Eigen::Vector3d& omega, double duration, double t) const;
  double ofOneStep(const RigidBody& body, double t, const Phase& p);

  Inertia inertia_;
  bool free_;
  std::string method_, unknown_;
  double step_;       ///< of the description [s]
  double taken_ = 0;  ///< the shortest step that a Taylor method takes instead, else step_ [s]
  double accuracy_;   ///< of the description [rad]
  FreeMethod row_;
  double local_ = 0;  ///< the largest error of one step under torques
};

}  // namespace poinsot::audit
