#include "poinsot/view/cones.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace poinsot::view {
namespace {

using Eigen::Vector3d;

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

TEST(Cones, anglesAreThoseBetweenAxisOmegaAndL) {
  for (int third = 0; third < 3; ++third) {
    for (const double ratio : {0.1, 0.6, 0.999999, 1.000001, 1.7, 20.0}) {
      for (const Vector3d& omega : {Vector3d(1, 2, 3), Vector3d(-0.01, 1, 0.02), Vector3d(3, -2, -1)}) {
        Vector3d moments(2, 2, 2);
        moments[third] *= ratio;
        const auto c = cones(moments, omega);
        ASSERT_TRUE(c);
        const Vector3d momentum = moments.cwiseProduct(omega);
        EXPECT_NEAR(std::abs(c->body_axis[third]), 1, 0);
        EXPECT_GT(c->body_axis.dot(omega), 0);
        EXPECT_NEAR(c->body_angle, angleBetween(c->body_axis, omega), 1e-14);
        EXPECT_NEAR(c->space_angle, angleBetween(momentum, omega), 1e-14);
        EXPECT_EQ(c->around, ratio > 1);
        const double tilt = angleBetween(c->body_axis, momentum);
        EXPECT_NEAR(tilt, c->body_angle + (ratio > 1 ? -1 : 1) * c->space_angle, 1e-14);
      }
    }
  }
}

TEST(Cones, areThereOnlyWhereTheyRoll) {
  EXPECT_FALSE(cones({1, 2, 3}, {1, 1, 1}));
  EXPECT_FALSE(cones({2, 2, 2}, {1, 1, 1}));
  EXPECT_FALSE(cones({2, 2, 3}, {0, 0, 1}));
  EXPECT_FALSE(cones({2, 2, 3}, {1, 2, 0}));
  EXPECT_FALSE(cones({2, 2, 3}, {0, 0, 0}));
}

}  // namespace
}  // namespace poinsot::view
