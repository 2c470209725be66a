#include "poinsot/core/inertia.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "draws.h"

namespace poinsot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <class Make>
std::string refusal(const Make& make) {
  try {
    make();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

void expectMentions(const std::string& message, const std::vector<std::string>& words) {
  for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << word << " in: " << message;
}

TEST(Inertia, momentsAreKeptInTheirOrder) {
  const PrincipalInertia inertia = PrincipalInertia::fromMoments({3, 1, 2});
  EXPECT_EQ(inertia.moments(), Vector3d(3, 1, 2));
  EXPECT_EQ(inertia.axes().coeffs(), Eigen::Quaterniond::Identity().coeffs());
  EXPECT_EQ(inertia.tensor(), Matrix3d(Vector3d(3, 1, 2).asDiagonal()));
}

TEST(Inertia, badMomentsAreNamed) {
  for (int i = 0; i < 3; ++i) {
    for (const double bad : {0.0, -2.5, kInfinity, -kInfinity, kNan}) {
      Vector3d moments(1, 1, 1);
      moments[i] = bad;
      expectMentions(refusal([&] { PrincipalInertia::fromMoments(moments); }),
                     {"moment " + std::to_string(i + 1), "expected a positive finite number (kg·m²), got "});
    }
  }
  expectMentions(refusal([] { PrincipalInertia::fromMoments({1, -2.5, 1}); }), {"moment 2", "got -2.5"});
}

TEST(Inertia, tinyAndHugeMomentsAreFine) {
  EXPECT_EQ(PrincipalInertia::fromMoments({1e-300, 1, 1e300}).moments(), Vector3d(1e-300, 1, 1e300));
}

TEST(Inertia, diagonalTensorKeepsItsOrder) {
  const PrincipalInertia inertia = PrincipalInertia::fromTensor(Vector3d(3, 1, 2).asDiagonal());
  EXPECT_EQ(inertia.moments(), Vector3d(3, 1, 2));
  EXPECT_EQ(inertia.axes().coeffs(), Eigen::Quaterniond::Identity().coeffs());
}

TEST(Inertia, tensorInAnyAxesIsReconstructed) {
  Draws draws;
  for (int i = 0; i < 500; ++i) {
    Vector3d moments = draws.moments();
    if (i % 5 == 0) moments[1] = moments[0];
    if (i % 50 == 0) moments[2] = moments[0];
    const Matrix3d turn = draws.attitude().toRotationMatrix();
    const Matrix3d tensor = turn * moments.asDiagonal() * turn.transpose();
    const PrincipalInertia inertia = PrincipalInertia::fromTensor(tensor);
    const Matrix3d axes = inertia.axes().toRotationMatrix();

    EXPECT_NEAR(inertia.axes().norm(), 1, 4e-16);
    EXPECT_NEAR(axes.determinant(), 1, 4e-15);  // and below: these axes, not their mirror image, are the principal ones
    EXPECT_LE((axes * inertia.moments().asDiagonal() * axes.transpose() - tensor).norm(), 4e-15 * tensor.norm());
    EXPECT_LE((inertia.tensor() - tensor).norm(), 4e-15 * tensor.norm());
    EXPECT_EQ(inertia.tensor(), inertia.tensor().transpose());

    std::sort(moments.begin(), moments.end());
    EXPECT_LE((inertia.moments() - moments).norm(), 4e-15 * moments.norm());
    EXPECT_TRUE(std::is_sorted(inertia.moments().begin(), inertia.moments().end()));
  }
}

TEST(Inertia, tensorOfAnySize) {
  Draws draws;
  for (const double size : {1e-250, 1e-100, 1e100, 1e250}) {
    const Matrix3d turn = draws.attitude().toRotationMatrix();
    const Matrix3d tensor = turn * (size * Vector3d(1, 2, 3)).asDiagonal() * turn.transpose();
    EXPECT_LE((PrincipalInertia::fromTensor(tensor).moments() / size - Vector3d(1, 2, 3)).norm(), 1e-14);
  }
}

TEST(Inertia, badTensorsAreRefusedWithTheReason) {
  Matrix3d tensor;
  tensor << 2, 0.1, 0, 0.2, 3, 0, 0, 0, 4;
  expectMentions(refusal([&] { PrincipalInertia::fromTensor(tensor); }), {"not symmetric", "(1,2)", "0.1", "0.2"});
  tensor << 1, 2, 0, 2, 1, 0, 0, 0, 3;
  expectMentions(refusal([&] { PrincipalInertia::fromTensor(tensor); }), {"not positive definite", "moments are -"});
  tensor << 1, 1, 0, 1, 1, 0, 0, 0, 3;
  expectMentions(refusal([&] { PrincipalInertia::fromTensor(tensor); }), {"not positive definite"});
  tensor << 1, kNan, 0, kNan, 1, 0, 0, 0, 3;
  expectMentions(refusal([&] { PrincipalInertia::fromTensor(tensor); }), {"not finite"});
  expectMentions(refusal([] { PrincipalInertia::fromTensor(Matrix3d::Zero()); }), {"moment 1", "positive"});
  expectMentions(refusal([] { PrincipalInertia::fromTensor(-Matrix3d::Identity()); }), {"moment 1", "-1"});
  tensor << -2, 0.1, 0, 0.1, -3, 0, 0, 0, -4;
  expectMentions(refusal([&] { PrincipalInertia::fromTensor(tensor); }), {"not positive definite"});
}

TEST(Inertia, asymmetryOfRoundoffIsForgiven) {
  Matrix3d tensor;
  tensor << 2, 0.1, 0, 0.1 + 1e-12, 3, 0, 0, 0, 4;
  const Matrix3d seen = PrincipalInertia::fromTensor(tensor).tensor();
  EXPECT_NEAR(seen(0, 1), 0.1, 1e-11);
}

TEST(Inertia, triangleInequality) {
  EXPECT_TRUE(PrincipalInertia::fromMoments({1, 2, 3}).satisfiesTriangleInequality());  // a plane figure: just
  EXPECT_TRUE(PrincipalInertia::fromMoments({3, 2, 2}).satisfiesTriangleInequality());
  EXPECT_TRUE(PrincipalInertia::fromMoments({0.1, 0.2, 0.1 + 0.2}).satisfiesTriangleInequality());  // but for roundoff
  EXPECT_TRUE(PrincipalInertia::fromMoments({1e308, 1e308, 1e308}).satisfiesTriangleInequality());
  EXPECT_FALSE(PrincipalInertia::fromMoments({1, 2, 3.0001}).satisfiesTriangleInequality());
  EXPECT_FALSE(PrincipalInertia::fromMoments({4, 2, 1}).satisfiesTriangleInequality());
}

}  // namespace
}  // namespace poinsot
