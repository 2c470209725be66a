#include "poinsot/cost/method_costs.h"

#include <stdexcept>

#include "poinsot/core/closed_form.h"

namespace poinsot::cost {

const MethodCost& MethodCosts::of(const std::string& method) const {
  const auto found = costs_.find(method);
  if (found != costs_.end()) return found->second;
  throw std::out_of_range("expected a method with a row in this table of costs, got " + method);
}

double MethodCosts::perSimulatedSecond(const std::string& method, double step, double rate) const {
  const MethodCost& cost = of(method);
  return rate * cost.per_state + (method == kClosedForm ? 0 : cost.per_step / step);
}

const MethodCosts& nominalCosts() {
  constexpr double ns = 1e-9;
  static const MethodCosts costs({
      {kClosedForm, {76 * ns, 0}},
      {"lie_euler", {104 * ns, 22 * ns}},
      {"buss2", {106 * ns, 27 * ns}},
      {"buss3", {140 * ns, 43 * ns}},
      {"buss4", {154 * ns, 66 * ns}},
      {"rk4", {130 * ns, 88 * ns}},
      {"rkmk4", {206 * ns, 118 * ns}},
      {"cf4", {208 * ns, 129 * ns}},
      {"midpoint", {282 * ns, 206 * ns}},
      {"splitting2", {166 * ns, 69 * ns}},
      {"splitting4", {342 * ns, 260 * ns}},
      {"splitting6", {522 * ns, 404 * ns}},
      {"dmv2", {152 * ns, 73 * ns}},
      {"dmv4", {220 * ns, 73 * ns}},
      {"dmv6", {290 * ns, 73 * ns}},
      {"dmv8", {346 * ns, 73 * ns}},
      {"dmv10", {400 * ns, 73 * ns}},
      {costName("taylor8", true), {184 * ns, 138 * ns}},
      {costName("taylor12", true), {257 * ns, 207 * ns}},
      {costName("taylor16", true), {364 * ns, 300 * ns}},
      {costName("taylor20", true), {480 * ns, 415 * ns}},
      {costName("taylor24", true), {620 * ns, 560 * ns}},
      {costName("aba84", true), {1198 * ns, 1469 * ns}},
      {costName("buss2", true), {147 * ns, 71 * ns}},
      {costName("rk4", true), {259 * ns, 189 * ns}},
  });
  return costs;
}

}  // namespace poinsot::cost
