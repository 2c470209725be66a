#pragma once

#include <map>
#include <string>

/** The cost of methods. */
namespace poinsot::cost {

/** CPU time of a method, in seconds. */
struct MethodCost {
  double per_state;  ///< for one state, without whole steps; includes a stepper's partial step
  double per_step;   ///< for a whole step; 0 for the closed form
};

/** Returns a method's name in MethodCosts; methods that also move free bodies have other costs under torques. */
inline std::string costName(const std::string& method, bool torqued) {
  return (torqued ? "torques/" : "") + method;
}

/** The costs by name of method, "closed_form" among them. */
class MethodCosts {
 public:
  explicit MethodCosts(std::map<std::string, MethodCost> costs) : costs_(std::move(costs)) {}

  /** Throws std::out_of_range for a method that is not in the table. */
  const MethodCost& of(const std::string& method) const;

  /**
   * Returns CPU seconds per simulated second of a motion that is asked for its state at `rate` [Hz].
   * @param step [s]; ignored for the closed form.
   */
  double perSimulatedSecond(const std::string& method, double step, double rate) const;

  const std::map<std::string, MethodCost>& all() const { return costs_; }

 private:
  std::map<std::string, MethodCost> costs_;
};

/**
 * Returns the costs of the methods on one machine, rounded; benchmark/method_costs measures them again. The choice of a
 * method depends on their proportions only, which differ little between machines. Because the figures are fixed, a
 * scene gets the same method and step everywhere and every time.
 */
const MethodCosts& nominalCosts();

}  // namespace poinsot::cost
