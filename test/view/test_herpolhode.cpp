#include "poinsot/view/herpolhode.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "random_body.h"

namespace poinsot::view {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

const Quaterniond kTilted = Quaterniond(0.7, -0.1, 0.5, 0.4).normalized();

ClosedForm motionOf(const Body& b) {
  return ClosedForm(b.moments, kTilted, b.omega);
}

struct Plane {
  Vector3d normal;
  double distance, longest;  ///< longest: |L|/μmin
};
/** From E and L. */
Plane planeOf(const Body& b) {
  const Vector3d l = kTilted * Vector3d(b.moments.cwiseProduct(b.omega));
  return {l / l.norm(), b.omega.dot(b.moments.cwiseProduct(b.omega)) / l.norm(), l.norm() / b.moments.minCoeff()};
}

double radiusOf(const Vector3d& p, const Plane& plane) {
  return (p - p.dot(plane.normal) * plane.normal).norm();
}

double distanceTo(const Curve& curve, const Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
    const Vector3d& a = curve.points[i];
    const Vector3d ab = curve.points[(i + 1) % n] - a;
    const double s = ab.squaredNorm() > 0 ? std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0) : 0.0;
    least = std::min(least, (p - a - s * ab).norm());
  }
  return least;
}

TEST(Herpolhode, liesOnThePlaneInItsAnnulusAndTheTipOfOmegaFollowsIt) {
  RandomBodies bodies(1);
  int closed = 0;
  for (int i = 0; i < 300; ++i) {
    const Body b = bodies.draw();
    const ClosedForm motion = motionOf(b);
    const Plane plane = planeOf(b);
    const InvariablePlane drawn = invariablePlane(motion);
    EXPECT_NEAR((drawn.normal - plane.normal).norm(), 0, 1e-14);
    EXPECT_NEAR(drawn.distance / plane.distance, 1, 1e-13);

    const Herpolhode h = herpolhode(motion);
    const auto& points = h.curve.points;
    ASSERT_GT(points.size(), 10u);
    EXPECT_LE(points.size(), 1024u);
    closed += h.curve.closed;
    double inner = plane.longest, outer = 0;
    for (const Vector3d& p : points) {
      EXPECT_NEAR(p.dot(plane.normal) / plane.distance, 1, 1e-12) << "a point is off the invariable plane";
      inner = std::min(inner, radiusOf(p, plane));
      outer = std::max(outer, radiusOf(p, plane));
    }
    EXPECT_NEAR(outer, h.outer, 1e-12 * plane.longest);
    EXPECT_GE(inner, h.inner - 1e-12 * plane.longest);
    EXPECT_NEAR(inner, h.inner, 1e-2 * plane.longest);
    EXPECT_NEAR(radiusOf(points.front(), plane), h.outer, 1e-12 * plane.longest);
    EXPECT_NEAR((motion.at(h.start).attitude * motion.at(h.start).omega_principal - points.front()).norm(), 0,
                1e-12 * plane.longest);
    if (h.curve.closed && h.outer - h.inner > 2e-3 * plane.longest) {
      EXPECT_LT((points.back() - points.front()).norm(), 0.5 * h.outer);  // no chord across
    }
    // All of the first half period is near the line.
    for (int k = 0; k <= 500; ++k) {
      const ClosedForm::State s = motion.at(h.start + motion.period() / 2 * k / 500);
      EXPECT_LT(distanceTo(h.curve, s.attitude * s.omega_principal), 2e-3 * plane.longest);
    }
    if (!h.curve.closed) {
      EXPECT_NEAR(radiusOf(points.back(), plane), h.outer, 1e-9 * plane.longest);
    }
  }
  EXPECT_LT(closed, 100);
}

TEST(Herpolhode, isACircleOfASymmetricBody) {
  for (const Body& b : {Body{{5, 5, 3}, {0, -0.84, 3}}, Body{{3, 7, 7}, {2, 1, -0.5}}, Body{{2, 1, 2}, {1, 1, -1}}}) {
    const Plane plane = planeOf(b);
    const Herpolhode h = herpolhode(motionOf(b));
    EXPECT_TRUE(h.curve.closed);
    EXPECT_NEAR(h.inner, h.outer, 1e-14 * plane.longest);
    double turned = 0;
    const auto& points = h.curve.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(radiusOf(points[i], plane), h.outer, 1e-13 * plane.longest);
      const Vector3d next = points[(i + 1) % points.size()];
      turned +=
          std::atan2(plane.normal.dot(points[i].cross(next)), points[i].dot(next) - plane.distance * plane.distance);
    }
    EXPECT_NEAR(turned, 2 * M_PI, 1e-9);  // once, about L
  }
}

TEST(Herpolhode, isClosedWhereItComesBack) {
  // Ω₁ such that three periods turn the body by whole turns.
  const auto motion = [](double o1) { return ClosedForm({1, 2, 3}, kTilted, {o1, 1, 1}); };
  const auto off = [&](double o1) { return std::remainder(3 * motion(o1).montgomeryAngle(), 2 * M_PI); };
  double low = 0.1, high = 0.1;
  while (off(low) * off(high) >= 0 || std::abs(off(high) - off(low)) > 1) {
    low = high;
    high += 0.01;
    ASSERT_LT(high, 1.6);
  }
  const double apart = high;
  for (int i = 0; i < 60; ++i) (off((low + high) / 2) * off(low) > 0 ? low : high) = (low + high) / 2;
  const Herpolhode h = herpolhode(motion(low));
  EXPECT_TRUE(h.curve.closed);
  const auto& points = h.curve.points;
  double longest = 0;
  for (std::size_t i = 1; i < points.size(); ++i) longest = std::max(longest, (points[i] - points[i - 1]).norm());
  EXPECT_LT((points.back() - points.front()).norm(), longest + 2e-3);
  EXPECT_FALSE(herpolhode(motion(apart + 0.03)).curve.closed);
}

TEST(Herpolhode, onTheSeparatrixGoesFromTheCentreAndBackToIt) {
  const Body b{{3, 4, 6}, {0.014, 3, -0.007}};
  const Plane plane = planeOf(b);
  const Herpolhode h = herpolhode(motionOf(b));
  const auto& points = h.curve.points;
  EXPECT_FALSE(h.curve.closed);
  EXPECT_LE(points.size(), 1024u);
  EXPECT_LT(radiusOf(points.front(), plane), 1.001e-3 * plane.longest);
  EXPECT_LT(radiusOf(points.back(), plane), 1.001e-3 * plane.longest);
  double outer = 0;
  for (const Vector3d& p : points) outer = std::max(outer, radiusOf(p, plane));
  // F = 2E I₂: |ω|² there is 2E (1/I₁ + 1/I₃ − I₂/(I₁I₃)).
  const double e2 = b.omega.dot(b.moments.cwiseProduct(b.omega));
  const double wanted = std::sqrt(e2 * (1 / 3.0 + 1 / 6.0 - 4 / 18.0) - plane.distance * plane.distance);
  EXPECT_NEAR(h.outer / wanted, 1, 1e-9);
  EXPECT_NEAR(outer / wanted, 1, 1e-2);
}

TEST(Herpolhode, isAPointWhereTheSpinIsSteadyAndNothingAtRest) {
  for (const Body& b : {Body{{1, 2, 3}, {0, 2, 0}}, Body{{2, 2, 2}, {1, 2, 3}}, Body{{2, 2, 3}, {1, 1, 0}}}) {
    const Herpolhode h = herpolhode(motionOf(b));
    ASSERT_EQ(h.curve.points.size(), 1u);
    EXPECT_NEAR((h.curve.points[0] - kTilted * b.omega).norm(), 0, 1e-14);
    EXPECT_EQ(h.outer, 0);
  }
  EXPECT_TRUE(herpolhode(ClosedForm({1, 2, 3}, kTilted, Vector3d::Zero())).curve.points.empty());
}

TEST(Herpolhode, hardBodiesKeepToTheirPoints) {
  for (const Body& b : {Body{{1, 2, 3}, {1e-12, 1, 1e-12}}, Body{{1, 2, 3}, {1e-150, 1, 1e-150}},
                        Body{{1, 1 + 1e-12, 1 + 2e-12}, {1, 1, 1}}, Body{{1, 1 + 1e-7, 2}, {1, 0.3, 2}},
                        Body{{1e-6, 1, 1.2}, {5, 1, 1}}, Body{{1, 2, 3}, {1e150, 1e150, 2e150}}}) {
    const Plane plane = planeOf(b);
    const Herpolhode h = herpolhode(motionOf(b));
    EXPECT_GT(h.curve.points.size(), 2u);
    EXPECT_LE(h.curve.points.size(), 1024u);
    for (const Vector3d& p : h.curve.points) {
      ASSERT_TRUE(p.allFinite());
      EXPECT_NEAR(p.dot(plane.normal) / plane.distance, 1, 1e-9);
    }
  }
}

}  // namespace
}  // namespace poinsot::view
