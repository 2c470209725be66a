#pragma once

#include <map>
#include <string>

/** What the methods cost on this machine. The room has a clock and a file; core has neither. */
namespace poinsot::cost {

/** CPU time of a method, in seconds. */
struct MethodCost {
  double
      per_state;  ///< of asking a motion for its state once, steps apart; for a stepper one partial step is part of it
  double per_step;  ///< of one more whole step; 0 for the closed form
};

/** By name of method, "closed_form" among them. */
class MethodCosts {
 public:
  explicit MethodCosts(std::map<std::string, MethodCost> costs) : costs_(std::move(costs)) {}

  /** Throws std::out_of_range for a method that is not in the table. */
  const MethodCost& of(const std::string& method) const { return costs_.at(method); }

  /**
   * CPU seconds per simulated second of a motion that is asked for its state at `rate` [Hz].
   * @param step [s]; ignored for the closed form.
   */
  double perSimulatedSecond(const std::string& method, double step, double rate) const;

  const std::map<std::string, MethodCost>& all() const { return costs_; }

 private:
  std::map<std::string, MethodCost> costs_;
};

/** Measures every method on a body of no special kind: half a second. */
MethodCosts measureCosts();

/** Where the measured costs are kept: $POINSOT_COSTS, else costs.yaml under poinsot/ in $ROS_HOME, else in ~/.ros. */
std::string defaultCostFile();

/**
 * The costs in the file, when it was written on this processor by this version; otherwise they are measured and written
 * there. A file that cannot be read or written is no error: what matters is measured anyway.
 */
MethodCosts costsOfThisMachine(const std::string& file = defaultCostFile(), bool measure_again = false);

}  // namespace poinsot::cost
