#include "poinsot/core/rotation.h"

#include <gtest/gtest.h>

#include "draws.h"
#include "half_turn.h"

namespace poinsot {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRoundoff = 4e-15;

const double kAngles[] = {0,    1e-320, 1e-300, 1e-200,     1e-160,     1e-100,     1e-20,       1e-12,
                          1e-9, 1e-6,   1e-3,   0.1,        0.4999999,  0.5,        0.5000001,   1,
                          2,    3,      3.1,    kPi - 1e-3, kPi - 1e-6, kPi - 1e-9, kPi - 1e-12, kPi - 1e-15};

/** The laws of the group, each over all angles and many axes. */
class RotationLaws : public ::testing::Test {
 protected:
  template <class Law>
  void forAll(const Law& law) {
    for (const double angle : kAngles) {
      for (int i = 0; i < 50; ++i) {
        const Vector3d axis = i < 3 ? Vector3d::Unit(i) : draws_.direction();
        SCOPED_TRACE(testing::Message() << "angle " << angle << ", axis " << axis.transpose());
        law(Vector3d(angle * axis));
      }
    }
  }
  Draws draws_;
};

double difference(const Quaterniond& a, const Quaterniond& b) {
  return (a.coeffs() - b.coeffs()).cwiseAbs().maxCoeff();
}
double difference(const Matrix3d& a, const Matrix3d& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

TEST_F(RotationLaws, logOfExp) {
  forAll([](const Vector3d& theta) {
    // Relative to the angle, down to where doubles lose their digits.
    const double allowed = kRoundoff * theta.stableNorm() + 1e-323;
    EXPECT_LE((logQuaternion(expQuaternion(theta)) - theta).stableNorm(), allowed);
  });
}

TEST_F(RotationLaws, logOfExpAsMatrices) {
  forAll([](const Vector3d& theta) { EXPECT_LE((logMatrix(expMatrix(theta)) - theta).stableNorm(), 2 * kRoundoff); });
}

TEST_F(RotationLaws, smallAnglesKeepTheirRelativePrecisionAsMatrices) {
  forAll([](const Vector3d& theta) {
    if (theta.stableNorm() > 0.1) return;
    EXPECT_LE((logMatrix(expMatrix(theta)) - theta).stableNorm(),
              kRoundoff * theta.stableNorm() + 1e-16 * theta.squaredNorm() + 1e-323);
  });
}

TEST_F(RotationLaws, exactlyPi) {
  // The opposite axis gives the same rotation at π, so rotations are compared and not vectors.
  for (int i = 0; i < 200; ++i) {
    const Vector3d theta = kPi * (i < 3 ? Vector3d::Unit(i) : draws_.direction());
    const Quaterniond q = expQuaternion(theta);
    EXPECT_NEAR(logQuaternion(q).norm(), kPi, kRoundoff);
    EXPECT_LE(angleBetween(q, expQuaternion(logQuaternion(q))), kRoundoff);
    EXPECT_LE(difference(expMatrix(logMatrix(expMatrix(theta))), expMatrix(theta)), kRoundoff);
  }
  EXPECT_NEAR(logQuaternion(Quaterniond(0, 0, 1, 0)).y(), kPi, 1e-15);
}

TEST_F(RotationLaws, quaternionAndItsNegativeHaveTheSameLog) {
  forAll([](const Vector3d& theta) {
    const Quaterniond q = expQuaternion(theta);
    EXPECT_EQ(logQuaternion(Quaterniond(Eigen::Vector4d(-q.coeffs()))), logQuaternion(q));
  });
}

TEST_F(RotationLaws, unitNorm) {
  forAll([](const Vector3d& theta) {
    EXPECT_NEAR(expQuaternion(theta).norm(), 1, 4e-16);
    EXPECT_LE(orthogonalityError(expMatrix(theta)), kRoundoff);
    EXPECT_NEAR(expMatrix(theta).determinant(), 1, kRoundoff);
  });
}

TEST_F(RotationLaws, inverse) {
  forAll([](const Vector3d& theta) {
    EXPECT_EQ(expQuaternion(-theta).coeffs(), expQuaternion(theta).conjugate().coeffs());
    EXPECT_LE(difference(Matrix3d(expMatrix(-theta) * expMatrix(theta)), Matrix3d::Identity()), kRoundoff);
  });
}

TEST_F(RotationLaws, turnsAboutOneAxisAdd) {
  forAll([](const Vector3d& theta) {
    EXPECT_LE(difference(expQuaternion(0.3 * theta) * expQuaternion(0.7 * theta), expQuaternion(theta)), 1e-15);
  });
}

TEST_F(RotationLaws, turnsComposeLikeMatrices) {
  forAll([this](const Vector3d& theta) {
    const Vector3d other = draws_.uniform(0, kPi) * draws_.direction();
    EXPECT_LE(difference((expQuaternion(theta) * expQuaternion(other)).toRotationMatrix(),
                         Matrix3d(expMatrix(theta) * expMatrix(other))),
              kRoundoff);
  });
}

TEST_F(RotationLaws, theAxisStays) {
  forAll([](const Vector3d& theta) {
    EXPECT_LE((expQuaternion(theta) * theta - theta).stableNorm(), kRoundoff * theta.stableNorm() + 1e-323);
  });
}

TEST_F(RotationLaws, conjugationTurnsTheAxis) {
  forAll([this](const Vector3d& theta) {
    const Quaterniond r = draws_.attitude();
    EXPECT_LE(angleBetween(r * expQuaternion(theta) * r.conjugate(), expQuaternion(r * theta)), kRoundoff);
  });
}

TEST_F(RotationLaws, expIsTheSeriesOfHat) {
  forAll([](const Vector3d& theta) {
    Matrix3d sum = Matrix3d::Identity(), term = Matrix3d::Identity();
    for (int n = 1; n < 40; ++n) {
      term = Matrix3d(term * hat(theta) / n);
      sum += term;
    }
    EXPECT_LE(difference(expMatrix(theta), sum), 2e-14);
  });
}

TEST_F(RotationLaws, angleBetweenIsTheAngleTurned) {
  forAll([this](const Vector3d& theta) {
    const Quaterniond a = draws_.attitude();
    EXPECT_NEAR(angleBetween(a, a * expQuaternion(theta)), theta.stableNorm(), kRoundoff);
    EXPECT_NEAR(angleBetween(a * expQuaternion(theta), a), theta.stableNorm(), kRoundoff);
  });
}

TEST_F(RotationLaws, renormaliseMakesUnit) {
  forAll([](const Vector3d& theta) {
    Quaternion q = expQuaternion(theta);
    q.coeffs() *= 1 + 1e-9;
    renormalise(q);
    EXPECT_NEAR(q.norm(), 1, 4e-16);
  });
}

TEST(Rotation, beyondHalfATurnTheShorterWayRoundComesBack) {
  EXPECT_NEAR(logQuaternion(expQuaternion({4, 0, 0})).x(), 4 - 2 * kPi, kRoundoff);
  EXPECT_NEAR(logQuaternion(expQuaternion({0, 2 * kPi, 0})).norm(), 0, kRoundoff);
  EXPECT_NEAR(angleBetween(Quaterniond::Identity(), expQuaternion({0, 0, 3 * kPi / 2})), kPi / 2, kRoundoff);
}

TEST(Rotation, hatIsTheCrossProduct) {
  Draws draws;
  for (int i = 0; i < 100; ++i) {
    const Vector3d v = draws.vector(), w = draws.vector();
    EXPECT_LE((hat(v) * w - v.cross(w)).norm(), 1e-15);
    EXPECT_EQ(hat(v).transpose(), -hat(v));
  }
}

TEST(Rotation, expIsContinuousWhereSeriesMeetsSine) {
  const Vector3d axis = Vector3d(1, -2, 2) / 3;
  const Quaterniond below = expQuaternion(std::nextafter(0.5, 0) * axis), above = expQuaternion(0.5 * axis);
  EXPECT_LE(difference(below, above), 3e-16);
  for (double angle = 0.45; angle < 0.55; angle += 1e-4) {
    const Quaterniond q = expQuaternion(angle * axis);
    EXPECT_NEAR(q.w(), std::cos(angle / 2), 2.3e-16);
    EXPECT_NEAR(q.vec().dot(axis), std::sin(angle / 2), 2.3e-16);
  }
}

TEST(Rotation, convention) {
  // Active, right-handed: a quarter turn about z takes x to y. Hamilton: v_world = q v q⁻¹ = R v.
  EXPECT_LE((expQuaternion({0, 0, kPi / 2}) * Vector3d::UnitX() - Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_LE((expMatrix({0, 0, kPi / 2}) * Vector3d::UnitX() - Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_LE(difference(Quaterniond(0, 1, 0, 0) * Quaterniond(0, 0, 1, 0), Quaterniond(0, 0, 0, 1)), 0);  // ij = k
  Draws draws;
  for (int i = 0; i < 100; ++i) {
    const Quaterniond q = draws.attitude();
    const Vector3d v = draws.vector();
    const Quaterniond sandwich = q * Quaterniond(0, v.x(), v.y(), v.z()) * q.inverse();
    EXPECT_LE((sandwich.vec() - q * v).norm(), 2e-15);
    EXPECT_LE((q.toRotationMatrix() * v - q * v).norm(), 2e-15);
    EXPECT_NEAR(sandwich.w(), 0, 1e-15);
  }
}

TEST(Rotation, orthogonalityErrorMeasuresHowFarFromARotation) {
  EXPECT_EQ(orthogonalityError(Matrix3d::Identity()), 0);
  EXPECT_NEAR(orthogonalityError(1.001 * Matrix3d::Identity()), 0.002001, 1e-12);
}

}  // namespace
}  // namespace poinsot
