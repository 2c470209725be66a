#include <gtest/gtest.h>

#include "poinsot/cost/cost_meter.h"

namespace poinsot::cost {
namespace {

constexpr double kTick = 0.1;  // s

MotionSetup setup(const std::string& method, std::optional<double> step) {
  MotionSetup out;
  out.inertia = PrincipalInertia::fromMoments({1, 2, 3});
  out.omega_body = {0.1, 1, 0.1};
  out.method = method;
  out.step = step;
  return out;
}

/** Ticks that are said to have cost `cpu` each; the last one is `last` long. */
double costAfter(const MotionSetup& setup, double cpu, double last) {
  Motion motion(setup);
  CostMeter meter(motion, 1 / kTick);
  double t = 0;
  for (int i = 0; i < 20; ++i) {
    const double tick = i == 19 ? last : kTick;
    motion.at(t += tick);
    meter.add(cpu, tick, t, motion);
  }
  return meter.cost();
}

// The figures differ by factors of 1000 and more where they are wrong.
TEST(CostMeter, cachesThatOthersHaveFilledAreNotCounted) {
  for (const MotionSetup& s : {setup("rk4", kTick), setup("closed_form", {})}) {
    EXPECT_LT(costAfter(s, 9e-4, kTick), 9e-4) << s.method << ": 9 ms a second were claimed for ticks of microseconds";
  }
}

TEST(CostMeter, aSliverOfTimeIsNotATick) {
  for (const MotionSetup& s : {setup("rk4", kTick), setup("closed_form", {})}) {
    const double usual = costAfter(s, 1e-6, kTick);
    EXPECT_LT(costAfter(s, 1e-6, 1e-9), 1000 * usual) << s.method;
  }
}

TEST(CostMeter, ticksThatAreLongCountAsTheyWere) {
  EXPECT_NEAR(costAfter(setup("rk4", 1e-5), 0.9, kTick), 9, 1e-3);  // 1e4 steps a tick: not replayed
}

}  // namespace
}  // namespace poinsot::cost
