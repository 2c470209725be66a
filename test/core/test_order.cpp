#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "draws.h"
#include "fine_integrator.h"
#include "poinsot/core/closed_form.h"
#include "poinsot/core/method.h"
#include "poinsot/core/rotation.h"

namespace poinsot {
namespace {

/** The attitude's error after n equal steps to t. */
double errorAt(const Stepper& stepper, const RotationState& start, const RotationState& truth, double t,
               std::int64_t n) {
  RotationState state = start;
  stepper.advance(state, 0, t / static_cast<double>(n), n);
  return angleBetween(state.attitude, truth.attitude);
}

TEST(FineIntegrator, agreesWithItselfRunBackwards) {
  const Eigen::Vector3d moments(1, 2, 3);
  const RotationState start = RotationState::fromOmega(moments, Draws().attitude(), {0.6, 0.5, 0.7});
  const RotationState there = integrateFinely(moments, start, 10), back = integrateFinely(moments, there, -10);
  EXPECT_LE(angleBetween(start.attitude, back.attitude), 1e-14);
  EXPECT_LE((start.momentum_principal - back.momentum_principal).norm(), 1e-14);
}

TEST(Order, isTheOneInTheTable) {
  Draws draws;
  struct Case {
    Eigen::Vector3d moments;
    RotationState start, truth;
    double t;
  };
  std::vector<Case> cases;
  for (int body = 0; body < 8; ++body) {
    const Eigen::Vector3d moments = draws.moments();
    const RotationState start = RotationState::fromOmega(moments, draws.attitude(), draws.direction());
    for (const double t : {1.7, 3.1, -5.3, 8.9})
      cases.push_back({moments, start, integrateFinely(moments, start, t), t});
  }

  for (const Method& method : freeMethods()) {
    // From the ratio of two errors at high orders: for them there is not much room between steps that show more than
    // the leading term and errors that are roundoff. Three steps then, the part that falls with h² taken out.
    // And from order eight on a longer time, which raises the error above roundoff: the closed form is the truth there.
    const bool high = method.order > 4, highest = method.order > 6;
    const double small = method.order <= 2 ? 1e-4 : 1e-8;
    const auto more = [high](std::int64_t n) { return high ? n + std::max<std::int64_t>(1, n / 4) : 2 * n; };
    std::vector<double> orders;
    for (Case c : cases) {
      if (highest) {
        c.t *= 100;
        c.truth.attitude = ClosedForm(c.moments, c.start.attitude, c.start.omegaPrincipal(c.moments)).at(c.t).attitude;
      }
      const auto stepper = method.make(c.moments);
      const auto error = [&](std::int64_t n) { return errorAt(*stepper, c.start, c.truth, c.t, n); };
      std::int64_t n =
          std::lround(std::ceil(std::abs(c.t) / (highest ? 1.0 : std::min(2.0, 0.05 * method.order * method.order))));
      double first = error(n), second = error(more(n));
      while (first > small) {
        n = more(n);
        first = second;
        second = error(more(n));
      }
      const std::int64_t n2 = more(n), n3 = more(n2);
      const double third = error(n3);
      if ((high ? third : second) < (highest ? 1e-11 : 5e-13)) continue;
      const auto h2 = [](std::int64_t m) { return 1.0 / (double(m) * double(m)); };
      const double order = std::log(first / second) / std::log(double(n2) / double(n));
      const double finer = std::log(second / third) / std::log(double(n3) / double(n2));
      const double part = (h2(n2) + h2(n3)) / (h2(n) + h2(n2));
      orders.push_back(high ? (finer - part * order) / (1 - part) : order);
    }
    ASSERT_GE(orders.size(), 10u) << method.name;
    std::sort(orders.begin(), orders.end());
    const double median = orders[orders.size() / 2];
    std::printf("%-10s order %.3f (%.3f to %.3f, %zu cases)\n", method.name, median, orders.front(), orders.back(),
                orders.size());
    // Of order ten, even the steps that are just above roundoff are too long for two terms: 9.6 to 10, towards 10.
    EXPECT_NEAR(median, method.order, method.order <= 8 ? 0.03 : 0.3) << method.name;
    EXPECT_NEAR(orders.front(), method.order, 0.5) << method.name;
    EXPECT_NEAR(orders.back(), method.order, 0.5) << method.name;
  }
}

}  // namespace
}  // namespace poinsot
