#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "draws.h"
#include "fine_integrator.h"
#include "poinsot/core/rotation.h"
#include "poinsot/core/stepper.h"

namespace poinsot {
namespace {

/** The attitude's error after n equal steps to t. */
double errorAt(const Stepper& stepper, const RotationState& start, const RotationState& truth, double t,
               std::int64_t n) {
  RotationState state = start;
  stepper.advance(state, t / n, n);
  return angleBetween(state.attitude, truth.attitude);
}

TEST(FineIntegrator, agreesWithItselfRunBackwards) {
  const Eigen::Vector3d moments(1, 2, 3);
  const RotationState start = RotationState::fromOmega(moments, Draws().attitude(), {0.6, 0.5, 0.7});
  const RotationState there = integrateFinely(moments, start, 10), back = integrateFinely(moments, there, -10);
  EXPECT_LE(angleBetween(start.attitude, back.attitude), 1e-14);
  EXPECT_LE((start.momentum_body - back.momentum_body).norm(), 1e-14);
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
    for (const double t : {0.7, 3.1, -5.3, 8.9})
      cases.push_back({moments, start, integrateFinely(moments, start, t), t});
  }

  for (const Method& method : methods()) {
    std::vector<double> orders;
    for (const Case& c : cases) {
      const auto stepper = method.make(c.moments);
      // Steps small enough for the leading term alone, large enough for roundoff not to show.
      std::int64_t n = std::lround(std::ceil(std::abs(c.t) / (0.05 * method.order)));
      double coarse = errorAt(*stepper, c.start, c.truth, c.t, n);
      double fine = errorAt(*stepper, c.start, c.truth, c.t, 2 * n);
      while (coarse > 1e-4) {
        n *= 2;
        coarse = fine;
        fine = errorAt(*stepper, c.start, c.truth, c.t, 2 * n);
      }
      if (fine > 1e-12) orders.push_back(std::log2(coarse / fine));
    }
    ASSERT_GE(orders.size(), 20u) << method.name;
    std::sort(orders.begin(), orders.end());
    const double median = orders[orders.size() / 2];
    std::printf("%-10s order %.3f (%.3f to %.3f, %zu cases)\n", method.name, median, orders.front(), orders.back(),
                orders.size());
    EXPECT_NEAR(median, method.order, 0.03) << method.name;
    EXPECT_NEAR(orders.front(), method.order, 0.5) << method.name;
    EXPECT_NEAR(orders.back(), method.order, 0.5) << method.name;
  }
}

}  // namespace
}  // namespace poinsot
