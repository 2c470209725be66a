/** Prints the cost of a state and of a step of each method here, beside the nominal costs that `accuracy:` uses. */
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "poinsot/core/method.h"
#include "poinsot/core/motion.h"
#include "poinsot/cost/cpu_time.h"
#include "poinsot/cost/method_costs.h"

namespace {

using namespace poinsot;
using cost::threadCpuTime;

constexpr int kStates = 1000;     // to one measurement
constexpr int kRepetitions = 12;  // the fastest counts: whatever disturbs makes it slower
constexpr double kStep = 0.01;    // s

/** Seconds per call of `use(motion, i)`, i = 0 … count − 1, on a fresh copy of the motion each time. */
template <class Use>
double fastest(const Motion& start, int count, Use use) {
  double best = 1e9;
  for (int r = 0; r < kRepetitions; ++r) {
    Motion motion = start;
    const double begin = threadCpuTime();
    for (int i = 0; i < count; ++i) use(motion, i);
    best = std::min(best, (threadCpuTime() - begin) / count);
  }
  return best;
}

/** A free body of no special kind, or, with effects, a heavy top. */
cost::MethodCost measure(const std::string& method, const std::vector<Effect>& effects = {}) {
  MotionSetup setup;
  setup.inertia = PrincipalInertia::fromMoments({1, 2, 3});
  setup.omega_body = {0.6, 0.5, 0.7};
  setup.method = method;
  setup.effects = effects;
  if (method != kClosedForm) setup.step = kStep;
  const Motion start(setup);
  [[maybe_unused]] volatile double sink = 0;
  // Each state takes a whole step and then a partial one.
  const double state =
      fastest(start, kStates, [&](Motion& motion, int i) { sink = motion.at((i + 0.5) * kStep).attitude.w(); });
  if (method == kClosedForm) return {state, 0};
  const double step = fastest(start, 1, [&](Motion& motion, int) { sink = motion.at(kStates * kStep).attitude.w(); });
  const double per_step = step / kStates;
  return {std::max(state - per_step, 0.0), per_step};
}

void print(const std::string& name, const cost::MethodCost& here) {
  const cost::MethodCost& nominal = cost::nominalCosts().of(name);
  std::printf("| %s | %.0f | %.0f | %.0f | %.0f |\n", name.c_str(), 1e9 * here.per_state, 1e9 * nominal.per_state,
              1e9 * here.per_step, 1e9 * nominal.per_step);
}

}  // namespace

int main(int argc, char**) {
  if (argc != 1) {
    std::fprintf(stderr, "usage: method_costs\n\nCPU time of the methods here and nominally; takes no arguments.\n");
    return 2;
  }
  std::printf("| method | ns per state | nominal | ns per step | nominal |\n|---|---|---|---|---|\n");
  print(kClosedForm, measure(kClosedForm));
  for (const Method& method : freeMethods()) print(method.name, measure(method.name));
  const GravityTorque weight{1, {0, 0, -1}, {0.1, -0.1, 0.3}};
  for (const Method& method : torquedMethods()) {
    print(cost::costName(method.name, true), measure(method.name, {weight}));
  }
  return 0;
}
