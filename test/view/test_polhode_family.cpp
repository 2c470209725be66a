#include "poinsot/view/polhode_family.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "poinsot/view/polhode.h"
#include "random_body.h"

namespace poinsot::view {
namespace {

using Eigen::Vector3d;

TEST(PolhodeFamily, hasOneMomentumAndAnEnergyForEachMember) {
  RandomBodies bodies(1);
  for (int i = 0; i < 500; ++i) {
    const Body b = bodies.draw();
    const double f = momentum2(b.moments, b.omega);
    std::array<double, 3> m{b.moments[0], b.moments[1], b.moments[2]};
    std::sort(m.begin(), m.end());
    const PolhodeFamily family = polhodeFamily(b.moments, b.omega);
    int above = 0, below = 0;
    for (const Curve& member : family.members) {
      EXPECT_TRUE(member.closed);
      const double e = energy2(b.moments, member.points.front());
      (e > f / m[1] ? above : below) += 1;
      EXPECT_GT(e, f / m[2]);
      EXPECT_LT(e, f / m[0]);
      for (const Vector3d& p : member.points) {
        EXPECT_NEAR(momentum2(b.moments, p) / f, 1, 1e-12);
        EXPECT_NEAR(energy2(b.moments, p) / e, 1, 1e-12);
      }
    }
    EXPECT_LE(family.members.size(), 30u);
    // At least one on either side; Ω may run beside the only one.
    EXPECT_GE(above + below, 2);
    ASSERT_EQ(family.separatrix.size(), 2u);
    for (const Curve& curve : family.separatrix) {
      for (const Vector3d& p : curve.points) {
        EXPECT_NEAR(momentum2(b.moments, p) / f, 1, 1e-12);
        EXPECT_NEAR(energy2(b.moments, p) * m[1] / f, 1, 1e-12);
      }
    }
  }
}

TEST(PolhodeFamily, isSpreadEvenlyWhereItCrossesTheMeridianAndLeavesRoomForThePresentOne) {
  const Vector3d moments(1, 2, 3);
  const PolhodeFamily family = polhodeFamily(moments, {0.9, 1, 0.2});
  // Crossing points of members about axis 1 in the plane Ω₂ = 0, by their angle along the ellipse of semi-axes 1, 1/3.
  std::vector<double> place;
  const auto along = [](double angle) {
    double length = 0;
    for (int i = 0; i < 20000; ++i) {
      const double a = angle * (i + 0.5) / 20000;
      length += std::hypot(std::sin(a), std::cos(a) / 3) * angle / 20000;
    }
    return length;
  };
  const double f = momentum2(moments, {0.9, 1, 0.2});
  for (const Curve& member : family.members) {
    const double e = energy2(moments, member.points.front());
    place.push_back(along(std::acos(std::sqrt((e - f / 3) / (f - f / 3)))));
  }
  const double own = along(std::acos(std::sqrt((energy2(moments, {0.9, 1, 0.2}) - f / 3) / (f - f / 3))));
  const double border = along(std::acos(std::sqrt((f / 2 - f / 3) / (f - f / 3))));
  const double end = along(M_PI / 2);
  std::sort(place.begin(), place.end());
  place.erase(std::unique(place.begin(), place.end(), [](double a, double b) { return std::abs(a - b) < 1e-9; }),
              place.end());
  EXPECT_EQ(2 * place.size(), family.members.size());  // each and its image
  std::vector<double> marks{0};
  marks.insert(marks.end(), place.begin(), place.end());
  for (const double extra : {border, end}) marks.push_back(extra);
  std::sort(marks.begin(), marks.end());
  for (std::size_t i = 1; i < marks.size(); ++i) {
    const double gap = marks[i] - marks[i - 1];
    const bool left_out = marks[i - 1] < own && own < marks[i];
    EXPECT_GT(gap, 0.1);
    EXPECT_LT(gap, left_out ? 0.45 : 0.26);
  }
  for (const double p : place) EXPECT_GT(std::abs(p - own), 0.05);
}

TEST(PolhodeFamily, ofASymmetricBodyAreCirclesFromThePoleToTheEquator) {
  for (const Vector3d& moments : {Vector3d(2, 2, 1), Vector3d(2, 2, 3), Vector3d(1, 2, 2)}) {
    const int third = moments[0] == moments[1] ? 2 : 0;
    const PolhodeFamily family = polhodeFamily(moments, {1, 0.2, 1});
    EXPECT_TRUE(family.separatrix.empty());
    EXPECT_GE(family.members.size(), 6u);
    for (const Curve& member : family.members) {
      for (const Vector3d& p : member.points) EXPECT_EQ(p[third], member.points.front()[third]);
      EXPECT_NE(member.points.front()[third], 0);
      EXPECT_NEAR(momentum2(moments, member.points.front()) / momentum2(moments, {1, 0.2, 1}), 1, 1e-12);
    }
  }
}

TEST(PolhodeFamily, isThereForSpinsAboutAnAxisAndNotForASphereOrAtRest) {
  for (int i = 0; i < 3; ++i) EXPECT_GE(polhodeFamily({1, 2, 3}, Vector3d::Unit(i)).members.size(), 8u);
  for (const Body& b : {Body{{2, 2, 2}, {1, 2, 3}}, Body{{1, 2, 3}, {0, 0, 0}}}) {
    const PolhodeFamily family = polhodeFamily(b.moments, b.omega);
    EXPECT_TRUE(family.members.empty());
    EXPECT_TRUE(family.separatrix.empty());
  }
}

TEST(PolhodeFamily, linesStrayFromTheEllipsoidByNoMoreThanTheTolerance) {
  RandomBodies bodies(0.6);
  for (int i = 0; i < 50; ++i) {
    const Body b = bodies.draw();
    const double longest = std::sqrt(momentum2(b.moments, b.omega)) / b.moments.minCoeff();
    const PolhodeFamily family = polhodeFamily(b.moments, b.omega, 0.17, 2e-3);
    std::vector<Curve> all = family.members;
    all.insert(all.end(), family.separatrix.begin(), family.separatrix.end());
    for (const Curve& curve : all) {
      for (std::size_t k = 0; k < curve.points.size(); ++k) {
        const Vector3d middle = 0.5 * (curve.points[k] + curve.points[(k + 1) % curve.points.size()]);
        const Vector3d momentum = b.moments.cwiseProduct(middle);
        const double inside = 1 - momentum.norm() / std::sqrt(momentum2(b.moments, b.omega));
        EXPECT_LT(inside * middle.norm(), 5e-3 * longest);
      }
    }
  }
}

}  // namespace
}  // namespace poinsot::view
