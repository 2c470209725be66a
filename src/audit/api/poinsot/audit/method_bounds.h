#pragma once

#include <string>

#include "poinsot/audit/free_motion.h"
#include "poinsot/audit/recording.h"

namespace poinsot::audit {

/**
 * What the method and the step that a description names allow a motion to be off by. The table of methods is the
 * audit's own. w is the fastest rate that the body reaches at its |L|, h the step, p the order, t the simulation time.
 */
class MethodBounds {
 public:
  explicit MethodBounds(const Description& description);

  bool known() const { return known_; }
  bool exact() const { return exact_; }  ///< the closed form
  const std::string& method() const { return method_; }
  double step() const { return step_; }

  /** Relative, of E, at time t: roundoff + C (wh)^p (1 + w|t|). Infinite for an unknown method. */
  double energy(const Inertia& inertia, const Eigen::Vector3d& omega_body, double t) const;
  /** Relative, of L as a vector (and of |L|). */
  double momentum(const Inertia& inertia, const Eigen::Vector3d& omega_body, double t) const;
  /** Of the attitude [rad], and of Ω relative to w, over `duration` of motion ending at t. */
  double local(const Inertia& inertia, const Eigen::Vector3d& omega_body, double duration, double t) const;

  /** Of the attitude of a free body against its true motion [rad], at time t; at most π. */
  double attitude(const Inertia& inertia, const Eigen::Vector3d& omega_body, double t) const;

  /** Relative, of what the method conserves exactly, after the |t|/h steps to t. */
  double roundoff(double t) const;

 private:
  double growth(const Inertia& inertia, const Eigen::Vector3d& omega_body, double t) const;

  std::string method_;
  double step_ = 0;
  bool known_ = false, exact_ = false, conserves_momentum_ = false, conserves_energy_ = false;
  int order_ = 0;
  double constant_ = 0;
};

}  // namespace poinsot::audit
