#pragma once

#include <string>
#include <vector>

#include "poinsot/audit/driven_motion.h"
#include "poinsot/audit/recording.h"

namespace poinsot::audit {

/** σ of a slug as a state shows it: (RᵀL − MΩ)/J. */
Phase phaseOf(const DrivenBody& body, const State& s);

/** What the method and the step that a description names allow a motion under torques to be off by. */
class DrivenBounds {
 public:
  /** @param states of the motion: what a step does to it depends on where it is. */
  DrivenBounds(const Description& description, const DrivenBody& body, const std::vector<const State*>& states);

  /** False for a method that the audit has no bound for, and for one whose steps are too long to say anything. */
  bool known() const { return known_; }
  /** The latter. */
  bool tooCoarse() const { return too_coarse_; }
  /** Of one step: attitude [rad], Ω and σ relative to speed(). */
  double local() const { return local_; }
  /** Steps begun within a duration, of those that the method takes where it halves them; two may be partial. */
  double steps(double duration) const;
  /** The same measure, of rounding, after so many steps, for figures of the size of their parts. */
  static double rounding(double steps);
  /** Of what is constant in the true motion, at time t from t = 0, in the same measure. */
  double drift(double t) const;

  const std::string& method() const { return method_; }
  double step() const { return step_; }

 private:
  std::string method_;
  double step_, taken_;
  bool known_ = false, too_coarse_ = false;
  double local_ = 0;
};

}  // namespace poinsot::audit
