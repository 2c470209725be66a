#include <gtest/gtest.h>

#include <cmath>

#include "poinsot/view/ellipsoids.h"
#include "poinsot/view/picture_scale.h"
#include "random_body.h"

namespace poinsot::view {
namespace {

double sumOfSquares(const Eigen::Vector3d& omega, const Eigen::Vector3d& axes) {
  return omega.cwiseQuotient(axes).squaredNorm();
}

TEST(Ellipsoids, knownValues) {
  // E = 8, μ = (1, 4, 16): √(16/μ); F = 64: 8/μ and not 8/√μ.
  EXPECT_TRUE(energySemiAxes({1, 4, 16}, 8).isApprox(Eigen::Vector3d(4, 2, 1), 1e-15));
  EXPECT_TRUE(momentumSemiAxes({1, 4, 16}, 64).isApprox(Eigen::Vector3d(8, 2, 0.5), 1e-15));
}

TEST(Ellipsoids, omegaLiesOnBoth) {
  RandomBodies bodies(3);
  for (int i = 0; i < 1000; ++i) {
    const Body b = bodies.draw();
    const Eigen::Vector3d momentum = b.moments.cwiseProduct(b.omega);
    const double energy = 0.5 * b.omega.dot(momentum);
    EXPECT_NEAR(sumOfSquares(b.omega, energySemiAxes(b.moments, energy)), 1, 1e-12);
    EXPECT_NEAR(sumOfSquares(b.omega, momentumSemiAxes(b.moments, momentum.squaredNorm())), 1, 1e-12);
  }
}

TEST(Ellipsoids, restIsAPoint) {
  EXPECT_EQ(energySemiAxes({1, 2, 3}, 0), Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(momentumSemiAxes({1, 2, 3}, 0), Eigen::Vector3d(0, 0, 0));
}

TEST(PictureScale, longestSemiAxisAndArrowHaveTheirLengths) {
  RandomBodies bodies(3);
  for (int i = 0; i < 1000; ++i) {
    const Body b = bodies.draw();
    const Eigen::Vector3d momentum = b.moments.cwiseProduct(b.omega);
    const PictureScale scale = pictureScale(b.moments, b.omega);
    const double longest = std::max(energySemiAxes(b.moments, 0.5 * b.omega.dot(momentum)).maxCoeff(),
                                    momentumSemiAxes(b.moments, momentum.squaredNorm()).maxCoeff());
    EXPECT_NEAR(longest * scale.metres_per_radian_per_second, kPictureRadius, 1e-12);
    EXPECT_NEAR(momentum.norm() * scale.metres_per_angular_momentum, kMomentumLength, 1e-12);
  }
}

TEST(PictureScale, fitsFromTinyToHuge) {
  for (const double size : {1e-150, 1e-100, 1e-20, 1.0, 1e20, 1e100, 1e150}) {
    for (const double moment : {1e-12, 1.0, 1e12}) {
      const Eigen::Vector3d moments = moment * Eigen::Vector3d(3, 1, 2);
      const Eigen::Vector3d omega = size * Eigen::Vector3d(0.5, -2, 1);
      const PictureScale scale = pictureScale(moments, omega);
      const Eigen::Vector3d momentum = moments.cwiseProduct(omega);
      EXPECT_NEAR(momentum.stableNorm() / moments.minCoeff() * scale.metres_per_radian_per_second, kPictureRadius,
                  1e-12);
      EXPECT_NEAR(momentum.stableNorm() * scale.metres_per_angular_momentum, kMomentumLength, 1e-12);
    }
  }
}

TEST(PictureScale, oneAtRestAndOutOfRange) {
  for (const Eigen::Vector3d& omega : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 5e-324, 0)}) {
    const PictureScale scale = pictureScale({1, 2, 3}, omega);
    EXPECT_EQ(scale.metres_per_radian_per_second, 1);
    EXPECT_EQ(scale.metres_per_angular_momentum, 1);
  }
}

}  // namespace
}  // namespace poinsot::view
