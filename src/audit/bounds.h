#pragma once

#include <string>
#include <vector>

#include "poinsot/audit/recording.h"
#include "rigid_body.h"

namespace poinsot::audit {

/** Where a state says that its body is; σ of a slug as it shows it: (RᵀL − MΩ)/J. */
Phase phaseOf(const RigidBody& body, const State& s);

/** A row of the audit's table of methods for free bodies. */
struct FreeMethod {
  const char* name = "";
  int order = -1;  ///< 0: exact; -1: not known
  bool keeps_momentum = false, keeps_energy = false;
  double constant = 0;  ///< C, of what it does not keep
};

/**
 * What the method and the step that a description names allow a motion to be off by. For free bodies that follows from
 * a table of methods of the audit's own: h is the step, p the order, w the fastest rate at the body's |L|. For bodies
 * under torques it follows from the Taylor series of the motion. doc/audit.md has the formulas.
 */
class Bounds {
 public:
  /** @param states of the motion: what a step does to a driven one depends on where it is. */
  Bounds(const Description& description, const RigidBody& body, const std::vector<const State*>& states);

  /** Why the method is held to no bound of its own; empty where it is. */
  const std::string& unknown() const { return unknown_; }
  bool exact() const { return row_.order == 0; }  ///< the closed form
  const std::string& method() const { return method_; }
  /** "method rk4 at step 0.001 s" */
  std::string methodAndStep() const;

  /**
   * What the method may do to a motion of that duration that begins with `a`: to the attitude [rad], to Ω and σ
   * relative to the speed [rad/s]. For a body under torques, how that grows meanwhile comes on top.
   */
  double allowed(const State& a, double speed, double duration) const;

  /** What E and L of a free body may be off by in a state, relatively. Infinite for an unknown method. */
  double energy(const State& s) const { return kept(inertia_.conditionOfEnergy(s.omega_body), row_.keeps_energy, s); }
  double momentum(const State& s) const {
    return kept(inertia_.conditionOfMomentum(s.omega_body), row_.keeps_momentum, s);
  }
  /** Of the attitude of a free body against its true motion [rad], at most π. */
  double attitude(const State& s) const;
  /** Of what is constant in a true motion under torques, at time t from t = 0, in the measure of `allowed`. */
  double drift(double t, double speed) const;

  /** What the steps within a duration are rounded by, relatively. */
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
  double step_, taken_ = 0;  ///< as named; as taken, where Taylor methods halve it
  double accuracy_;          ///< asked for [rad]
  FreeMethod row_;
  double local_ = 0;  ///< what one step under torques may do
};

}  // namespace poinsot::audit
