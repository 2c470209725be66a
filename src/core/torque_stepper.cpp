#include "poinsot/core/torque_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "torque_steppers/aba84.h"
#include "torque_steppers/buss2.h"
#include "torque_steppers/rk4.h"
#include "torque_steppers/taylor.h"

namespace poinsot {
namespace {

template <class Scheme>
std::unique_ptr<TorqueStepper> make(const Torques& torques) {
  return std::make_unique<Scheme>(torques);
}

}  // namespace

Work TorqueStepper::advance(TorquedState& state, double t, double h) const {
  const std::vector<double>& switches = torques_.switches();
  if (switches.empty()) return step(state, t, h, torques_.constant(0));

  const double end = t + h;
  // A switch that rounding has put beside an end of the step is at that end.
  const double near = 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(t), std::abs(end));
  const double low = std::min(t, end) + near, high = std::max(t, end) - near;
  const auto first = std::upper_bound(switches.begin(), switches.end(), low);
  const auto last = std::lower_bound(first, switches.end(), high);
  const auto count = last - first;
  TorquedState moved = state;  // step() may throw
  Work work;
  double from = t;
  for (std::ptrdiff_t i = 0; i <= count; ++i) {
    const bool at_end = i == count;
    const double to = at_end ? end : h > 0 ? first[i] : last[-1 - i];
    const double length = at_end ? h - (from - t) : to - from;
    work += step(moved, from, length, torques_.constant(torques_.intervalAt(0.5 * (from + to))));
    from = to;
  }
  state = moved;
  return work;
}

const std::vector<TorqueMethod>& torqueMethods() {
  static const std::vector<TorqueMethod> table = {
      // name, order, takes torques that depend on Omega, cuts steps
      {"taylor8", 8, true, true, make<torque_steppers::Taylor<8>>},
      {"taylor12", 12, true, true, make<torque_steppers::Taylor<12>>},
      {"taylor16", 16, true, true, make<torque_steppers::Taylor<16>>},
      {"taylor20", 20, true, true, make<torque_steppers::Taylor<20>>},
      {"taylor24", 24, true, true, make<torque_steppers::Taylor<24>>},
      {"aba84", 4, false, false, make<torque_steppers::Aba84>},
      {"buss2", 2, true, false, make<torque_steppers::Buss2>},
      {"rk4", 4, true, false, make<torque_steppers::Rk4>},
  };
  return table;
}

const TorqueMethod* findTorqueMethod(const std::string& name) {
  for (const TorqueMethod& method : torqueMethods()) {
    if (name == method.name) return &method;
  }
  return nullptr;
}

std::string torqueMethodNames() {
  std::string names;
  for (const TorqueMethod& method : torqueMethods()) names += (names.empty() ? "" : ", ") + std::string(method.name);
  return names;
}

std::string objectionTo(const TorqueMethod& method, const Torques& torques) {
  if (method.takes_damping || torques.dependsOnAttitudeOnly()) return "";
  return std::string(method.name) + " takes torques that depend on time and attitude alone, not damping or dissipation";
}

}  // namespace poinsot
