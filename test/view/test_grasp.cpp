#include "poinsot/view/grasp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace poinsot::view {
namespace {

using Eigen::Vector3d;

const Vector3d kAxes(1, 0.6, 0.3);

double level(const Vector3d& axes, const Vector3d& p) {
  return p.cwiseQuotient(axes).squaredNorm();
}

Vector3d draw(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

TEST(PointTowards, liesOnTheEllipsoidInThatDirection) {
  std::mt19937_64 random{1};
  for (int i = 0; i < 1000; ++i) {
    const Vector3d p = 3 * draw(random);
    const auto q = pointTowards(kAxes, p);
    ASSERT_TRUE(q);
    EXPECT_NEAR(level(kAxes, *q), 1, 1e-14);
    EXPECT_NEAR(q->normalized().dot(p.normalized()), 1, 1e-14);
  }
}

TEST(PointTowards, takesPlacesOfAnySize) {
  for (const double size : {1e-300, 1e-160, 1e160, 1e308}) {
    const auto q = pointTowards(kAxes, size * Vector3d(0, 1, 1));
    ASSERT_TRUE(q) << size;
    EXPECT_NEAR(level(kAxes, *q), 1, 1e-14);
    EXPECT_NEAR(q->y(), q->z(), 1e-15);
  }
}

TEST(PointTowards, hasNoneForTheCentreAndForWhatIsNotFinite) {
  EXPECT_FALSE(pointTowards(kAxes, Vector3d::Zero()));
  EXPECT_FALSE(pointTowards(kAxes, Vector3d(HUGE_VAL, 0, 0)));
  EXPECT_FALSE(pointTowards(kAxes, Vector3d(0, std::nan(""), 0)));
}

TEST(PointInSight, isTheNearEndOfTheChordAlongTheLineOfSight) {
  std::mt19937_64 random{2};
  int met = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3d eye = 6 * draw(random).normalized();
    const Vector3d inside = 0.9 * *pointTowards(kAxes, draw(random));
    // Any point of the line stands for it, also one beyond the ellipsoid.
    const Vector3d point = eye + 1.7 * (inside - eye);
    const auto q = pointInSight(kAxes, eye, point);
    ASSERT_TRUE(q);
    EXPECT_NEAR(level(kAxes, *q), 1, 1e-13);
    EXPECT_NEAR((*q - eye).normalized().dot((point - eye).normalized()), 1, 1e-13);
    EXPECT_LT((*q - eye).norm(), (inside - eye).norm());  // nothing of the ellipsoid is before it
    ++met;
  }
  EXPECT_EQ(met, 1000);
}

TEST(PointInSight, besideTheEllipsoidIsOnItsRim) {
  const Vector3d eye(5, 0, 0);
  const auto q = pointInSight(kAxes, eye, Vector3d(0, 9, 0));
  ASSERT_TRUE(q);
  EXPECT_NEAR(level(kAxes, *q), 1, 1e-14);
  EXPECT_GT(q->y(), 0);
  // On the rim the line of sight touches.
  const Vector3d normal = q->cwiseQuotient(kAxes.cwiseProduct(kAxes)).normalized();
  EXPECT_NEAR(normal.dot((eye - *q).normalized()), 0, 1e-12);
}

TEST(PointInSight, followsAHandWithoutAJumpAcrossTheRim) {
  const Vector3d eye(5, 0.3, 0.8);
  Vector3d last = *pointInSight(kAxes, eye, Vector3d(0, -1.2, 0));
  for (int i = 1; i <= 2400; ++i) {
    const Vector3d next = *pointInSight(kAxes, eye, Vector3d(0, -1.2 + 0.001 * i, 0));
    EXPECT_LT((next - last).norm(), 0.06) << i;  // steepest where the line of sight grazes
    last = next;
  }
}

TEST(PointInSight, withTheEyeInsideGoesByTheDirection) {
  const Vector3d point(0, 0.1, 0.1);
  EXPECT_EQ(*pointInSight(kAxes, Vector3d::Zero(), point), *pointTowards(kAxes, point));
}

TEST(PointInSight, hasNoneForWhatIsNotFinite) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(pointInSight(kAxes, Vector3d(5, 0, 0), Vector3d(inf, 0, 0)));
  EXPECT_FALSE(pointInSight(kAxes, Vector3d(inf, 0, 0), Vector3d(1, 0, 0)));
  EXPECT_FALSE(pointInSight(kAxes, Vector3d(5, 0, 0), Vector3d(5, 0, 0)));
}

}  // namespace
}  // namespace poinsot::view
