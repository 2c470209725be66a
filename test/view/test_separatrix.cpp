#include <gtest/gtest.h>

#include <cmath>

#include "poinsot/view/separatrix.h"
#include "random_body.h"

namespace poinsot::view {
namespace {

TEST(Separatrix, liesOnTheEnergyEllipsoidAndHasTheMomentumOfTheIntermediateAxis) {
  RandomBodies bodies(3);
  for (int i = 0; i < 300; ++i) {
    const Body b = bodies.draw();
    const double energy = 0.5 * b.omega.dot(b.moments.cwiseProduct(b.omega));
    const double intermediate = b.moments.sum() - b.moments.maxCoeff() - b.moments.minCoeff();
    const std::vector<Curve> curves = separatrix(b.moments, energy, 64);
    ASSERT_EQ(curves.size(), 2u);
    for (const Curve& curve : curves) {
      EXPECT_TRUE(curve.closed);
      EXPECT_EQ(curve.points.size(), 64u);
      for (const Eigen::Vector3d& p : curve.points) {
        const Eigen::Vector3d momentum = b.moments.cwiseProduct(p);
        EXPECT_NEAR(p.dot(momentum) / (2 * energy), 1, 1e-12);
        EXPECT_NEAR(momentum.squaredNorm() / (2 * energy * intermediate), 1,
                    1e-12 * b.moments.maxCoeff() / intermediate);
      }
    }
  }
}

TEST(Separatrix, curvesCrossAtTheIntermediateAxis) {
  // μ = (3, 1, 2): axis 3 is the intermediate one, √(2E/2) = 2 for E = 4.
  const std::vector<Curve> curves = separatrix({3, 1, 2}, 4, 64);
  ASSERT_EQ(curves.size(), 2u);
  for (const Curve& curve : curves) {
    EXPECT_NEAR((curve.points[0] - Eigen::Vector3d(0, 0, 2)).norm(), 0, 1e-15);
    EXPECT_NEAR((curve.points[32] + Eigen::Vector3d(0, 0, 2)).norm(), 0, 1e-15);
  }
  // The two planes are each other's mirror image, and different.
  EXPECT_GT((curves[0].points[16] - curves[1].points[16]).norm(), 1);
}

TEST(Separatrix, noneForEqualMomentsOrAtRest) {
  EXPECT_TRUE(separatrix({2, 2, 1}, 1).empty());
  EXPECT_TRUE(separatrix({1, 2, 1}, 1).empty());
  EXPECT_TRUE(separatrix({2, 2, 2}, 1).empty());
  EXPECT_TRUE(separatrix({1, 2, 3}, 0).empty());
}

TEST(Separatrix, finiteInHardCases) {
  for (const Eigen::Vector3d& moments :
       {Eigen::Vector3d(1, 1e12, 1e6), Eigen::Vector3d(1, 1 + 3e-16, 2), Eigen::Vector3d(1e-200, 2e-200, 1e-212),
        Eigen::Vector3d(1, 1 + 3e-16, 1 + 6e-16)}) {
    for (const double energy : {1e-300, 1e-30, 1.0, 1e30, 1e300}) {
      for (const Curve& curve : separatrix(moments, energy)) {
        for (const Eigen::Vector3d& p : curve.points) {
          ASSERT_TRUE(p.allFinite()) << moments.transpose() << ", E " << energy;
          ASSERT_GT(p.cwiseAbs().maxCoeff(), 0);
        }
      }
    }
  }
}

}  // namespace
}  // namespace poinsot::view
