#include <gtest/gtest.h>

#include <cstdio>

#include "draws.h"
#include "poinsot/core/invariants.h"
#include "poinsot/core/method.h"

namespace poinsot {
namespace {

using Eigen::Vector3d;

/** In an order that does not depend on the compiler, as that of a call's arguments does. */
RotationState drawState(Draws& draws, const Vector3d& moments) {
  const Vector3d omega = draws.direction();
  return RotationState::fromOmega(moments, draws.attitude(), omega);
}

struct Drifts {
  double energy, momentum;  ///< worst, relative
};

Drifts worstDrifts(const Method& method, double step, int steps) {
  Draws draws;
  Drifts worst{0, 0};
  for (int body = 0; body < 5; ++body) {
    const Vector3d moments = draws.moments();
    const auto stepper = method.make(moments);
    RotationState state = drawState(draws, moments);
    const Invariants start = invariantsOf(moments, state);
    for (int done = 0; done < steps; done += 100) {
      stepper->advance(state, 0, step, 100);
      const Invariants now = invariantsOf(moments, state);
      worst.energy = std::max(worst.energy, std::abs(energyDrift(now, start)));
      worst.momentum = std::max(worst.momentum, momentumDrift(now, start));
    }
  }
  return worst;
}

TEST(Conservation, eachMethodKeepsWhatItClaimsAndNothingElse) {
  for (const Method& method : freeMethods()) {
    const Drifts drifts = worstDrifts(method, 0.05, 100000);
    std::printf("%-10s |dE|/E %.1e   |dL|/|L| %.1e\n", method.name, drifts.energy, drifts.momentum);
    if (method.conserves_momentum) {
      EXPECT_LE(drifts.momentum, 4e-15) << method.name;
    } else {
      EXPECT_GE(drifts.momentum, 1e-8) << method.name;
    }
    if (method.conserves_energy) {
      EXPECT_LE(drifts.energy, 1e-14) << method.name;
    } else {
      // Where the error of that step is near roundoff, a longer step shows it.
      const double energy = std::max(drifts.energy, worstDrifts(method, 2.5, 1000).energy);
      EXPECT_GE(energy, 1e-8) << method.name;
    }
  }
}

TEST(Conservation, theErrorOfEStaysBoundedOnlyUnderSymmetricMethods) {
  for (const Method& method : freeMethods()) {
    if (method.conserves_energy) continue;
    const std::string name = method.name;
    // Steps at which the error is far above roundoff, and that of first order not yet all that it can be.
    const double step = method.order == 1 ? 1e-3 : method.order <= 3 ? 0.2 : method.order == 4 ? 0.5 : 1.5;
    const double early = worstDrifts(method, step, 1000).energy, late = worstDrifts(method, step, 100000).energy;
    std::printf("%-10s |dE|/E %.1e until 1e3 steps, %.1e until 1e5\n", method.name, early, late);
    EXPECT_GE(early, 1e-10) << method.name;
    if (name == "midpoint" || name.rfind("splitting", 0) == 0) {
      EXPECT_LE(late, 2 * early) << method.name;
    } else {
      EXPECT_GE(late, 3 * early) << method.name;
    }
  }
}

TEST(LieEuler, energyRisesAtEveryStepUntilTheSpinIsAboutTheSmallestMoment) {
  Draws draws;
  for (int body = 0; body < 20; ++body) {
    const Vector3d moments = draws.moments();
    const auto stepper = findMethod("lie_euler")->make(moments);
    RotationState state = drawState(draws, moments);
    const double most = 0.5 * state.momentum_principal.squaredNorm() / moments.minCoeff();
    double energy = invariantsOf(moments, state).kinetic_energy;
    for (int n = 0; n < 20000; ++n) {
      stepper->advance(state, 0, 0.1, 1);
      const double next = invariantsOf(moments, state).kinetic_energy;
      ASSERT_GE(next, energy * (1 - 2e-15)) << "step " << n;
      energy = next;
    }
    // However near to the largest moment it began; moments that differ little take longer.
    const double spread = moments.maxCoeff() / moments.minCoeff();
    if (spread > 1.2) {
      EXPECT_GT(energy, 0.99 * most) << moments.transpose();
    }
  }
}

TEST(LieEuler, energyGainOfAStep) {
  Draws draws;
  for (int body = 0; body < 50; ++body) {
    const Vector3d moments = draws.moments();
    RotationState state = drawState(draws, moments);
    const Vector3d omega = state.omegaPrincipal(moments), rate = state.momentum_principal.cross(omega);
    const double h = 1e-4, predicted = 0.5 * h * h * rate.dot(rate.cwiseQuotient(moments));
    if (predicted < 1e-10) continue;  // lost in the roundoff of E
    const double before = invariantsOf(moments, state).kinetic_energy;
    findMethod("lie_euler")->make(moments)->advance(state, 0, h, 1);
    EXPECT_NEAR((invariantsOf(moments, state).kinetic_energy - before) / predicted, 1, 1e-3 + 1e-15 / predicted);
  }
}

TEST(Buss2, energyRatioAfterALongRun) {
  const Vector3d moments(1, 2, 3);
  RotationState state = RotationState::fromOmega(moments, Eigen::Quaterniond::Identity(), {0.6, 0.5, 0.7});
  const double before = invariantsOf(moments, state).kinetic_energy;
  findMethod("buss2")->make(moments)->advance(state, 0, 0.1, 20000);
  const double ratio = invariantsOf(moments, state).kinetic_energy / before;
  std::printf("buss2: E/E0 = %.6f at t = 2000, h = 0.1\n", ratio);
  EXPECT_NEAR(ratio, 1.20, 0.005);
}

}  // namespace
}  // namespace poinsot
