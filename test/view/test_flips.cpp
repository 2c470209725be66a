#include "poinsot/view/flips.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

#include "random_body.h"

namespace poinsot::view {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

ClosedForm motionOf(const Body& b) {
  return ClosedForm(b.moments, Quaterniond::Identity(), b.omega);
}

int middleOf(const Vector3d& moments) {
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int a, int b) { return moments[a] < moments[b]; });
  return order[1];
}

/** Sign changes of Λ₂ from t = 0 to `until`, stepping in that direction. */
struct Watched {
  int changes = 0;
  double largest_swing = 0, first = kInfinity;  ///< first: when the first change was [s], of either sign
};
Watched watch(const ClosedForm& motion, double until, int samples) {
  Watched out;
  const int middle = middleOf(motion.moments());
  double last = 0;
  for (int i = 0; i <= samples; ++i) {
    const double t = until * i / samples;
    const Vector3d lambda = motion.moments().cwiseProduct(motion.at(t).omega_principal);
    const double swing = lambda[middle] / lambda.norm();
    out.largest_swing = std::max(out.largest_swing, std::abs(swing));
    if (swing * last < 0) {
      if (out.changes++ == 0) out.first = t;
    }
    last = swing;
  }
  return out;
}

TEST(Flips, areCountedAndForetoldAsOneSeesThem) {
  RandomBodies bodies(1);
  int flip = 0, wobble = 0;
  for (int i = 0; i < 300; ++i) {
    const Body b = bodies.draw();
    const ClosedForm motion = motionOf(b);
    ASSERT_EQ(motion.regime(), ClosedForm::Regime::general);
    for (const double turns : {0.3, 2.7, -1.6, -0.2}) {
      const double t = turns * motion.period();
      const Watched seen = watch(motion, t, 4000);
      const Flips forwards = flipsOf(motion, t, 1), backwards = flipsOf(motion, t, -0.5);
      const double swing = std::abs(turns) > 1 ? seen.largest_swing : largestSwing(motion);
      if (std::abs(turns) > 1) {
        EXPECT_NEAR(largestSwing(motion), swing, 1e-5);
      }
      if (std::abs(swing - std::sqrt(0.5)) < 1e-5) continue;  // too close to tell from samples
      ASSERT_EQ(forwards.flips, swing > std::sqrt(0.5)) << b.moments.transpose() << "; " << b.omega.transpose();
      EXPECT_EQ(backwards.flips, forwards.flips);
      EXPECT_EQ(flipsOf(motion, t, 0).to_next, forwards.to_next);  // paused
      if (!forwards.flips) {
        ++wobble;
        EXPECT_EQ(forwards.since_start, 0);
        EXPECT_EQ(forwards.to_next, kInfinity);
        continue;
      }
      ++flip;
      EXPECT_EQ(forwards.since_start, t < 0 ? -seen.changes : seen.changes);
      EXPECT_EQ(backwards.since_start, forwards.since_start);
      // At the flips that are foretold Λ₂ vanishes, and it does not change its sign before.
      const int middle = middleOf(b.moments);
      for (const double at : {t + forwards.to_next, t - backwards.to_next}) {
        ASSERT_NE(at, t);
        const double before = motion.at(t).omega_principal[middle], size = motion.at(t).omega_principal.norm();
        EXPECT_NEAR(motion.at(at).omega_principal[middle] / size, 0, 1e-10);
        for (int k = 1; k < 20; ++k) EXPECT_GT(motion.at(t + (at - t) * k / 20).omega_principal[middle] * before, 0);
      }
      EXPECT_NEAR((forwards.to_next + backwards.to_next) / motion.period(), 0.5, 1e-9);
    }
  }
  EXPECT_GT(flip, 200);
  EXPECT_GT(wobble, 200);
}

TEST(Flips, aStableSpinThatWobblesHasNone) {
  for (const Vector3d& omega : {Vector3d(3, 0.3, 0.3), Vector3d(0.3, 0.3, 3)}) {
    const Flips flips = flipsOf(ClosedForm({1, 2.34, 3.07}, Quaterniond::Identity(), omega), 50, 1);
    EXPECT_FALSE(flips.flips);
    EXPECT_EQ(flips.since_start, 0);
    EXPECT_EQ(flips.to_next, kInfinity);
  }
  EXPECT_TRUE(flipsOf(ClosedForm({1, 2.34, 3.07}, Quaterniond::Identity(), {0.3, 3, 0.3}), 50, 1).flips);
}

TEST(Flips, noneOfSymmetricBodiesSteadySpinsAndRest) {
  for (const Body& b : {Body{{2, 2, 1}, {3, 2, 0.1}}, Body{{1, 2, 2}, {0.1, 3, 2}}, Body{{1, 2, 3}, {0, 1, 0}},
                        Body{{2, 2, 2}, {1, 2, 3}}, Body{{1, 2, 3}, {0, 0, 0}}}) {
    EXPECT_EQ(largestSwing(motionOf(b)), 0);
    for (const double direction : {1, -1}) {
      const Flips flips = flipsOf(motionOf(b), 7, direction);
      EXPECT_FALSE(flips.flips);
      EXPECT_EQ(flips.since_start, 0);
      EXPECT_EQ(flips.to_next, kInfinity);
    }
  }
}

TEST(Flips, oneOnTheSeparatrix) {
  // Ω₂ = 3 tanh(6 − t) within 1e-5 of it (scenes/separatrix.yaml), and its mirror image in time.
  const ClosedForm later({3, 4, 6}, Quaterniond::Identity(), {0.014, 3, -0.007});
  const ClosedForm before({3, 4, 6}, Quaterniond::Identity(), {-0.014, -3, 0.007});
  ASSERT_EQ(later.regime(), ClosedForm::Regime::separatrix);
  const double when = flipsOf(later, 0, 1).to_next;
  EXPECT_NEAR(later.at(when).omega_principal[1], 0, 1e-12);
  const auto expectFlips = [](const ClosedForm& motion, double t, double direction, int count, double to_next) {
    const Flips flips = flipsOf(motion, t, direction);
    EXPECT_TRUE(flips.flips);
    EXPECT_EQ(flips.since_start, count) << t;
    if (std::isinf(to_next)) {
      EXPECT_EQ(flips.to_next, to_next) << t;
    } else {
      EXPECT_NEAR(flips.to_next, to_next, 1e-12) << t;
    }
  };
  expectFlips(later, -20, 1, 0, when + 20);
  expectFlips(later, 1, 1, 0, when - 1);
  expectFlips(later, 1, -1, 0, kInfinity);
  expectFlips(later, 9, 1, 1, kInfinity);
  expectFlips(later, 9, -1, 1, 9 - when);
  for (const double t : {-9.0, -1.0, 4.0}) {
    const double flip = t - flipsOf(before, t, t > -when ? -1 : 1).to_next * (t > -when ? 1 : -1);
    EXPECT_NEAR(before.at(flip).omega_principal[1], 0, 1e-9);
    EXPECT_LT(flip, -5);
  }
  expectFlips(before, -20, 1, -1, flipsOf(before, -20, 1).to_next);
  expectFlips(before, 0, 1, 0, kInfinity);
  EXPECT_EQ(flipsOf(before, -1, 1).since_start, 0);
}

TEST(Flips, theOneAtTheStartDoesNotCount) {
  for (const Body& b : {Body{{1, 2, 3}, {0.9, 0, 0.52}}, Body{{4, 5, 9}, {3, 0, 1}}}) {  // general, separatrix
    const ClosedForm motion = motionOf(b);
    ASSERT_TRUE(flipsOf(motion, 0, 1).flips);
    const double soon = 1e-3;
    EXPECT_EQ(flipsOf(motion, 0, 1).since_start, 0);
    EXPECT_EQ(flipsOf(motion, soon, 1).since_start, 0);
    EXPECT_EQ(flipsOf(motion, -soon, 1).since_start, 0);
    EXPECT_NEAR(flipsOf(motion, soon, -1).to_next, soon, 1e-12);
    EXPECT_NEAR(flipsOf(motion, -soon, 1).to_next, soon, 1e-12);
    if (motion.regime() == ClosedForm::Regime::separatrix) continue;
    EXPECT_DOUBLE_EQ(flipsOf(motion, 0, 1).to_next, motion.period() / 2);
    EXPECT_DOUBLE_EQ(flipsOf(motion, 0, -1).to_next, motion.period() / 2);
  }
}

TEST(Flips, goOnForAsLongAsTimesAreTold) {
  const ClosedForm motion({1, 2, 3}, Quaterniond::Identity(), {0.01, 1, 0.01});
  const double half = motion.period() / 2;
  for (const double t : {1e6, -1e6, 1e9}) {
    const Flips flips = flipsOf(motion, t, 1);
    EXPECT_NEAR(static_cast<double>(flips.since_start), t / half, 1.01);
    EXPECT_LE(flips.to_next, half);
  }
  EXPECT_EQ(flipsOf(motion, 1e300, 1).since_start, std::int64_t{1} << 53);
  EXPECT_THROW(flipsOf(motion, kInfinity, 1), std::invalid_argument);
}

TEST(Flips, everyRegimeHasItsWords) {
  const auto words = [](const Eigen::Vector3d& moments, const Eigen::Vector3d& omega) {
    return std::string(textOf(polhode(moments, omega).regime, moments, omega));
  };
  EXPECT_EQ(words({1, 2, 3}, {2, 5, 1}), "about the axis of smallest moment");
  EXPECT_EQ(words({1, 2, 3}, {1, 5, 1}), "about the axis of largest moment");
  EXPECT_EQ(words({3, 2, 1}, {2, 0, 0}), "steady about the axis of largest moment");
  EXPECT_EQ(words({3, 2, 1}, {0, -2, 0}), "steady about the axis of intermediate moment");
  EXPECT_EQ(words({3, 2, 1}, {0, 0, 1e-200}), "steady about the axis of smallest moment");
  EXPECT_EQ(words({2, 2, 1}, {0, 0, 1}), "steady about the axis of smallest moment");
  EXPECT_EQ(words({2, 2, 1}, {1, 5, 0}), "steady about an axis of equal moments");
  EXPECT_EQ(words({4, 5, 9}, {3, -1, 1}), "on the separatrix");
  EXPECT_EQ(words({2, 2, 3}, {1, 5, 1}), "about the axis of symmetry");
  EXPECT_EQ(words({2, 2, 2}, {1, 5, 1}), "steady: three equal moments");
  EXPECT_EQ(words({1, 2, 3}, {0, 0, 0}), "at rest");
}

}  // namespace
}  // namespace poinsot::view
