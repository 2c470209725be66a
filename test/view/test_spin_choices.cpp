#include "poinsot/view/spin_choices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "poinsot/core/closed_form.h"
#include "random_body.h"

namespace poinsot::view {
namespace {

using Eigen::Vector3d;

void expectKept(const Vector3d& moments, const Vector3d& before, const Vector3d& after, ConservedQuantity keep) {
  if (keep == ConservedQuantity::energy) {
    EXPECT_NEAR(energy2(moments, after) / energy2(moments, before), 1, 4e-15);
  } else {
    EXPECT_NEAR(std::sqrt(momentum2(moments, after) / momentum2(moments, before)), 1, 4e-15);
  }
}

int axisOf(const Vector3d& moments, Axis axis) {
  Eigen::Index least, most;
  moments.minCoeff(&least);
  moments.maxCoeff(&most);
  if (axis == Axis::smallest) return static_cast<int>(least);
  if (axis == Axis::largest) return static_cast<int>(most);
  return static_cast<int>(3 - least - most);
}

constexpr ConservedQuantity kKeeps[] = {ConservedQuantity::energy, ConservedQuantity::momentum};
constexpr Axis kAxes[] = {Axis::smallest, Axis::intermediate, Axis::largest};

TEST(SpinChoices, keepEnergyOrMomentumAndTheAxisAskedFor) {
  RandomBodies bodies(1);
  for (int i = 0; i < 300; ++i) {
    const Body b = bodies.draw();
    for (const ConservedQuantity keep : kKeeps) {
      for (const Axis axis : kAxes) {
        const int k = axisOf(b.moments, axis);
        const Vector3d spin = axisSpin(b.moments, b.omega, keep, axis);
        expectKept(b.moments, b.omega, spin, keep);
        EXPECT_EQ(spin.cwiseAbs().sum(), std::abs(spin[k]));
        EXPECT_GT(spin[k] * b.omega[k], 0) << "in the sense of the spin before";
        const Vector3d near = nearAxis(b.moments, b.omega, keep, axis);
        expectKept(b.moments, b.omega, near, keep);
        EXPECT_GT(near[k] * b.omega[k], 0);
      }
    }
  }
}

TEST(SpinChoices, nearAnAxisIsInItsRegimeByTheClosedForm) {
  RandomBodies bodies(1);
  for (int i = 0; i < 300; ++i) {
    const Body b = bodies.draw();
    for (const ConservedQuantity keep : kKeeps) {
      for (const Axis axis : {Axis::smallest, Axis::largest}) {
        const ClosedForm motion(b.moments, Eigen::Quaterniond::Identity(), nearAxis(b.moments, b.omega, keep, axis));
        EXPECT_EQ(motion.regime(), ClosedForm::Regime::general);
        EXPECT_EQ(motion.encircledAxis(), axisOf(b.moments, axis));
      }
      const Vector3d start = nearAxis(b.moments, b.omega, keep, Axis::intermediate);
      const ClosedForm flipping(b.moments, Eigen::Quaterniond::Identity(), start);
      const int k = axisOf(b.moments, Axis::intermediate);
      const Vector3d later = flipping.at(0.5 * flipping.period()).omega_principal;
      EXPECT_NEAR(later[k] / start[k], -1, 1e-6) << "half a period later it is turned over";
    }
  }
}

TEST(SpinChoices, onSeparatrixIsAsNearAsDoublesCome) {
  RandomBodies bodies(1);
  for (int i = 0; i < 300; ++i) {
    const Body b = bodies.draw();
    for (const ConservedQuantity keep : kKeeps) {
      const Vector3d start = onSeparatrix(b.moments, b.omega, keep);
      expectKept(b.moments, b.omega, start, keep);
      const ClosedForm motion(b.moments, Eigen::Quaterniond::Identity(), start);
      EXPECT_LT(motion.separatrixDistance(), 1e-7);  // k' goes with the root of the roundoff
      // First it leaves the end of the intermediate axis, then passes to the other one.
      const int k = axisOf(b.moments, Axis::intermediate);
      EXPECT_GT(start[k] * b.omega[k], 0);
      const double flip = motion.timeToNextFlip(0);
      EXPECT_LT(std::abs(motion.at(0.2 * flip).omega_principal[k]), std::abs(start[k]));
      EXPECT_LT(motion.at(2 * flip).omega_principal[k] * start[k], 0);
    }
  }
}

TEST(SpinChoices, thereIsNoSeparatrixOfASymmetricBody) {
  EXPECT_THROW(onSeparatrix({1, 1, 2}, {1, 0, 1}, ConservedQuantity::energy), std::invalid_argument);
  EXPECT_THROW(onSeparatrix({2, 1, 2}, {1, 0, 1}, ConservedQuantity::momentum), std::invalid_argument);
}

TEST(SpinChoices, takeSpinsOfAnySize) {
  for (const double size : {1e-150, 1e150}) {
    const Vector3d moments(1, 2, 3), omega = size * Vector3d(0.1, 1, 0.2);
    for (const ConservedQuantity keep : kKeeps) {
      const Vector3d small = onSeparatrix(moments, Vector3d(0.1, 1, 0.2), keep);
      EXPECT_NEAR((onSeparatrix(moments, omega, keep) / size - small).norm(), 0, 1e-14);
      EXPECT_NEAR(axisSpin(moments, omega, keep, Axis::largest)[2] / size /
                      axisSpin(moments, Vector3d(0.1, 1, 0.2), keep, Axis::largest)[2],
                  1, 1e-14);
    }
  }
}

}  // namespace
}  // namespace poinsot::view
