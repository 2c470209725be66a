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

  /** False where nothing is known of the method at this step, and no accuracy was asked for. */
  bool known() const { return by_ != By::nothing; }
  /** Of those, the known methods whose steps are too long to say anything. */
  bool tooCoarse() const { return too_coarse_; }
  /** Over a duration, of the attitude [rad], of Ω and σ relative to the speed. */
  double allowed(double duration, double speed) const;
  /** Of what is constant in the true motion, at time t from t = 0, in the same measure; with rounding. */
  double drift(double t, double speed) const;
  /** Steps begun within a duration, of those that the method takes where it halves them; two may be partial. */
  double steps(double duration) const;

  const std::string& method() const { return method_; }
  double step() const { return step_; }

 private:
  enum class By { nothing, steps, accuracy };

  std::string method_;
  double step_, taken_ = 0;  ///< as named; as taken
  By by_ = By::nothing;
  bool too_coarse_ = false;
  double local_ = 0;     ///< of one step
  double accuracy_ = 0;  ///< asked for [rad]
};

}  // namespace poinsot::audit
