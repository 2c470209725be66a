#include "poinsot/view/polhode.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "random_body.h"

namespace poinsot::view {
namespace {

using Eigen::Vector3d;

double distanceToSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d ab = b - a;
  const double length2 = ab.squaredNorm();
  const double s = length2 > 0 ? std::min(1.0, std::max(0.0, (p - a).dot(ab) / length2)) : 0.0;
  return (p - a - s * ab).norm();
}

double distanceTo(const Curve& curve, const Vector3d& p) {
  double least = (p - curve.points[0]).norm();
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
    least = std::min(least, distanceToSegment(p, curve.points[i], curve.points[(i + 1) % n]));
  }
  return least;
}

/** Checks what holds in every regime, for Ω of ordinary size. @param tolerance of the two identities, relative. */
void expectSound(const Body& b, const Polhode& result, double tolerance = 1e-12) {
  const double e = energy2(b.moments, b.omega), f = momentum2(b.moments, b.omega);
  ASSERT_GE(result.branches.size(), 2u);
  for (const Curve& branch : result.branches) {
    double longest = 0, total = 0;
    const std::size_t n = branch.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vector3d& p = branch.points[i];
      ASSERT_TRUE(p.allFinite());
      EXPECT_NEAR(energy2(b.moments, p) / e, 1, tolerance);
      EXPECT_NEAR(momentum2(b.moments, p) / f, 1, tolerance);
      if (n > 1 && (branch.closed || i + 1 < n)) {
        const double piece = (branch.points[(i + 1) % n] - p).norm();
        longest = std::max(longest, piece);
        total += piece;
      }
    }
    if (n > 1) {
      EXPECT_LT(longest, 1.5 * total / static_cast<double>(n)) << b.moments.transpose() << "; " << b.omega.transpose();
    }
  }
  const auto& first = result.branches[0].points;
  const auto& second = result.branches[1].points;
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i], -second[i]);
  // Half a segment of a 256-gon strays from its curve by about (length/256)²/8 times the curvature.
  EXPECT_LT(distanceTo(result.branches[0], b.omega), 2e-2 * b.omega.norm());
}

int axisOf(const Vector3d& moments, bool largest) {
  int axis;
  largest ? moments.maxCoeff(&axis) : moments.minCoeff(&axis);
  return axis;
}

TEST(Polhode, randomBodiesInAnyOrderOfAxes) {
  RandomBodies bodies(1.5);
  int largest = 0, smallest = 0;
  for (int i = 0; i < 1000; ++i) {
    const Body b = bodies.draw();
    const Polhode result = polhode(b.moments, b.omega);
    expectSound(b, result);
    ASSERT_EQ(result.branches.size(), 2u);
    ASSERT_TRUE(result.regime == Regime::about_largest || result.regime == Regime::about_smallest);
    (result.regime == Regime::about_largest ? largest : smallest)++;
    EXPECT_EQ(result.branches[0].points.size(), 256u);
    // The axis that the loop goes round keeps its sign, Ω's own on the first branch.
    const int axis = axisOf(b.moments, result.regime == Regime::about_largest);
    for (const Vector3d& p : result.branches[0].points) EXPECT_GT(p[axis] * b.omega[axis], 0);
  }
  EXPECT_GT(largest, 100);
  EXPECT_GT(smallest, 100);
}

TEST(Polhode, numberOfPoints) {
  EXPECT_EQ(polhode({1, 2, 3}, {0.1, 0.2, 1}, 100).branches[0].points.size(), 100u);
  EXPECT_EQ(polhode({1, 2, 3}, {0.1, 0.2, 1}, 101).branches[0].points.size(), 104u);
  EXPECT_EQ(polhode({1, 2, 3}, {0.1, 0.2, 1}, -5).branches[0].points.size(), 8u);
}

/** One period and more of MΩ̇ = MΩ × Ω by the classical Runge–Kutta method, |Ω|h = 0.002. */
std::vector<Vector3d> integrated(const Body& b, double duration) {
  const auto rate = [&](const Vector3d& o) -> Vector3d {
    return b.moments.cwiseProduct(o).cross(o).cwiseQuotient(b.moments);
  };
  std::vector<Vector3d> out{b.omega};
  const double h = 0.002 / b.omega.norm();
  for (double t = 0; t < duration; t += h) {
    const Vector3d o = out.back();
    const Vector3d k1 = rate(o), k2 = rate(o + 0.5 * h * k1), k3 = rate(o + 0.5 * h * k2), k4 = rate(o + h * k3);
    out.push_back(o + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4));
  }
  return out;
}

TEST(Polhode, isTheCurveThatEulersEquationsRunThrough) {
  for (const Body& b : {Body{{1, 2, 3}, {0.6, 0.5, 0.7}}, Body{{3, 1, 2}, {0.3, -1.0, 0.4}},
                        Body{{2, 3, 1}, {1.0, 0.02, -0.01}}, Body{{1, 1, 2}, {0.3, 0.4, -0.5}}}) {
    const Polhode result = polhode(b.moments, b.omega);
    const Curve path{integrated(b, 60), false};
    const Curve& branch = result.branches[0];
    for (std::size_t i = 0; i < path.points.size(); i += 50) EXPECT_LT(distanceTo(branch, path.points[i]), 3e-4);
    for (std::size_t i = 0; i < branch.points.size(); i += 7) EXPECT_LT(distanceTo(path, branch.points[i]), 1e-6);
  }
}

TEST(Polhode, regimes) {
  // F − 2E·2 = 3Ω₃² − Ω₁² for μ = (1, 2, 3).
  EXPECT_EQ(polhode({1, 2, 3}, {1, 5, 1}).regime, Regime::about_largest);
  EXPECT_EQ(polhode({1, 2, 3}, {2, 5, 1}).regime, Regime::about_smallest);
  EXPECT_EQ(polhode({3, 2, 1}, {1, 5, 1}).regime, Regime::about_largest);
  EXPECT_EQ(polhode({2, 3, 1}, {5, 1, 2}).regime, Regime::about_smallest);
  EXPECT_EQ(polhode({1, 2, 3}, {0, 1, 1e-200}).regime, Regime::about_largest);
  EXPECT_EQ(polhode({1, 2, 3}, {1e-200, 1, 0}).regime, Regime::about_smallest);
  EXPECT_EQ(polhode({4, 5, 9}, {3, -1, 1}).regime, Regime::separatrix);
  EXPECT_EQ(polhode({9, 4, 5}, {1, 3, 0}).regime, Regime::separatrix);
  EXPECT_EQ(polhode({4, 5, 9}, {3 + 1e-15, -1, 1}).regime, Regime::about_smallest);
  EXPECT_EQ(polhode({4, 5, 9}, {3 - 1e-15, -1, 1}).regime, Regime::about_largest);
  EXPECT_EQ(polhode({4, 5, 9}, {3, -1e-170, 1}).regime, Regime::separatrix);
  EXPECT_EQ(polhode({4, 5, 9}, {std::ldexp(3, -560), 1, std::ldexp(1, -560)}).regime, Regime::separatrix);
  EXPECT_EQ(polhode({2, 2, 3}, {1, 5, 1}).regime, Regime::circle);
  EXPECT_EQ(polhode({3, 2, 3}, {1, 5, 1}).regime, Regime::circle);
  EXPECT_EQ(polhode({2, 2, 3}, {1, 5, 0}).regime, Regime::axis_spin);
  EXPECT_EQ(polhode({2, 2, 3}, {0, 0, -1}).regime, Regime::axis_spin);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(polhode({1, 2, 3}, Vector3d::Unit(i)).regime, Regime::axis_spin);
  EXPECT_EQ(polhode({2, 2, 2}, {1, 5, 1}).regime, Regime::sphere);
  EXPECT_EQ(polhode({1, 2, 3}, {0, 0, 0}).regime, Regime::rest);
  EXPECT_EQ(polhode({2, 2, 2}, {0, 0, 0}).regime, Regime::rest);
}

TEST(Polhode, separatrixHasFourArcsBetweenTheIntermediateAxisEnds) {
  for (const Body& b : {Body{{4, 5, 9}, {3, -1, 1}}, Body{{4, 5, 9}, {-3, 2, 1}}, Body{{5, 9, 4}, {0, -1, -3}}}) {
    const Polhode result = polhode(b.moments, b.omega);
    ASSERT_EQ(result.regime, Regime::separatrix);
    ASSERT_EQ(result.branches.size(), 4u);
    expectSound(b, result);
    EXPECT_LT(distanceTo(result.branches[0], b.omega), 1e-4 * b.omega.norm());
    int intermediate = 3 - axisOf(b.moments, true) - axisOf(b.moments, false);
    const double end = std::sqrt(energy2(b.moments, b.omega) / b.moments[intermediate]);
    for (const Curve& arc : result.branches) {
      EXPECT_FALSE(arc.closed);
      EXPECT_EQ(arc.points.size(), 257u);
      EXPECT_NEAR(std::abs(arc.points.front()[intermediate]), end, 1e-14 * end);
      EXPECT_NEAR((arc.points.front() + arc.points.back()).norm(), 0, 1e-14 * end);
    }
  }
}

TEST(Polhode, closeToTheSeparatrixTheCornersAreThere) {
  for (const double eps : {1e-2, 1e-4, 1e-8, 1e-12, 1e-100, 1e-160}) {
    const Body b{{1, 2, 3}, {eps, 1, eps}};  // F − 2E·2 = 2 eps²
    const Polhode result = polhode(b.moments, b.omega);
    EXPECT_EQ(result.regime, Regime::about_largest);
    expectSound(b, result);
    double nearest = 1;
    for (const Vector3d& p : result.branches[0].points) nearest = std::min(nearest, std::hypot(p[0], p[2]));
    // At the waist Ω₁ = 0 and 3Ω₃² = 3eps² − eps².
    EXPECT_NEAR(nearest / (eps * std::sqrt(2.0 / 3)), 1, 1e-12);
  }
}

TEST(Polhode, axisSpinIsAPointAndItsImage) {
  const Polhode result = polhode({1, 2, 3}, {0, -2.5, 0});
  ASSERT_EQ(result.branches.size(), 2u);
  ASSERT_EQ(result.branches[0].points.size(), 1u);
  EXPECT_EQ(result.branches[0].points[0], Vector3d(0, -2.5, 0));
  EXPECT_EQ(result.branches[1].points[0], Vector3d(0, 2.5, 0));
}

TEST(Polhode, circle) {
  const Body b{{3, 2, 3}, {3e-3, -5e-3, 4e-3}};
  const Polhode result = polhode(b.moments, b.omega);
  expectSound(b, result);
  for (const Vector3d& p : result.branches[0].points) {
    EXPECT_EQ(p[1], -5e-3);
    EXPECT_NEAR(std::hypot(p[0], p[2]), 5e-3, 1e-17);
  }
}

TEST(Polhode, noCurveForASphereOrAtRest) {
  EXPECT_TRUE(polhode({2, 2, 2}, {1, 5, 1}).branches.empty());
  EXPECT_TRUE(polhode({1, 2, 3}, {0, 0, 0}).branches.empty());
}

TEST(Polhode, hardMomentsStayOnBothEllipsoids) {
  const double ulp = std::numeric_limits<double>::epsilon();
  std::vector<Vector3d> hard;
  for (const Vector3d& m :
       {Vector3d(1, 1e12, 1e12 + 0.5), Vector3d(1, 1e6, 1e12), Vector3d(1e-12, 1, 1 + ulp), Vector3d(1, 1 + ulp, 2),
        Vector3d(1, 1 + ulp, 1 + 2 * ulp), Vector3d(1, 2, 100), Vector3d(1, 1, 10), Vector3d(1e-200, 2e-200, 3e-188)}) {
    Vector3d p = m;
    for (int i = 0; i < 3; ++i) {
      hard.push_back(p);
      p = Vector3d(p[1], p[2], p[0]);
    }
  }
  RandomBodies bodies(1);
  for (const Vector3d& moments : hard) {
    for (int i = 0; i < 50; ++i) {
      Body b{moments / moments.maxCoeff(), bodies.draw().omega};
      if (i % 5 == 1) b.omega[i % 3] *= 1e-9;
      if (i % 5 == 2) b.omega[i % 3] = 0;
      const Polhode result = polhode(moments, b.omega);
      const double e = energy2(b.moments, b.omega), f = momentum2(b.moments, b.omega);
      for (const Curve& branch : result.branches) {
        for (const Vector3d& p : branch.points) {
          ASSERT_TRUE(p.allFinite());
          ASSERT_NEAR(energy2(b.moments, p) / e, 1, 1e-12) << moments.transpose() << "; " << b.omega.transpose();
          ASSERT_NEAR(momentum2(b.moments, p) / f, 1, 1e-12) << moments.transpose() << "; " << b.omega.transpose();
        }
      }
    }
  }
}

TEST(Polhode, scalesWithOmega) {
  const Vector3d moments(2, 3, 1), omega(0.3, -0.2, 0.9);
  const Polhode reference = polhode(moments, omega);
  for (const int exponent : {-1000, -500, -30, 30, 500, 1000}) {
    const double size = std::ldexp(1.0, exponent);
    const Polhode result = polhode(moments, size * omega);
    for (std::size_t i = 0; i < result.branches[0].points.size(); ++i) {
      EXPECT_EQ(result.branches[0].points[i], size * reference.branches[0].points[i]);
    }
  }
}

}  // namespace
}  // namespace poinsot::view
