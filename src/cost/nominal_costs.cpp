#include "poinsot/cost/nominal_costs.h"

#include "poinsot/core/closed_form.h"

namespace poinsot::cost {

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
  });
  return costs;
}

}  // namespace poinsot::cost
