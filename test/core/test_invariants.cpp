#include "poinsot/core/invariants.h"

#include <gtest/gtest.h>

#include <limits>

#include "draws.h"

namespace poinsot {
namespace {

using Eigen::Vector3d;

TEST(Invariants, knownValues) {
  // Ω = (1, 2, 3), μ = (2, 3, 5): 2E = 2 + 12 + 45, Λ = (2, 6, 15); a quarter turn about z: L = (−6, 2, 15).
  const double half = std::sqrt(0.5);
  const Vector3d moments(2, 3, 5);
  const RotationState state = RotationState::fromOmega(moments, Eigen::Quaterniond(half, 0, 0, half), {1, 2, 3});
  const Invariants invariants = invariantsOf(moments, state);
  EXPECT_DOUBLE_EQ(invariants.kinetic_energy, 29.5);
  EXPECT_DOUBLE_EQ(invariants.momentum_squared, 265);
  EXPECT_LE((invariants.momentum_world - Vector3d(-6, 2, 15)).norm(), 1e-14);
  EXPECT_LE((state.omegaPrincipal(moments) - Vector3d(1, 2, 3)).norm(), 1e-15);
}

TEST(Invariants, momentumSquaredIsThatOfL) {
  Draws draws;
  for (int i = 0; i < 100; ++i) {
    const Vector3d moments = draws.moments();
    const Invariants invariants =
        invariantsOf(moments, RotationState::fromOmega(moments, draws.attitude(), draws.vector()));
    EXPECT_NEAR(invariants.momentum_world.squaredNorm() / invariants.momentum_squared, 1, 4e-15);
  }
}

TEST(Invariants, drifts) {
  const Invariants reference{2, 9, {0, 0, 3}};
  EXPECT_DOUBLE_EQ(energyDrift({2.5, 9, {0, 0, 3}}, reference), 0.25);
  EXPECT_DOUBLE_EQ(energyDrift({1.5, 9, {0, 0, 3}}, reference), -0.25);
  EXPECT_EQ(momentumDrift(reference, reference), 0);
  EXPECT_DOUBLE_EQ(momentumDrift({2, 9, {0, 3, 0}}, reference), std::sqrt(2.0));  // a turn of L counts
}

TEST(Invariants, driftFromRest) {
  EXPECT_EQ(energyDrift(Invariants{}, Invariants{}), 0);
  EXPECT_EQ(momentumDrift(Invariants{}, Invariants{}), 0);
  EXPECT_EQ(energyDrift({1, 1, {0, 0, 1}}, Invariants{}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(momentumDrift({1, 1, {0, 0, 1}}, Invariants{}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace poinsot
