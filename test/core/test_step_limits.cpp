#include "poinsot/core/method.h"
#include "poinsot/core/step_limits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "draws.h"
#include "poinsot/core/closed_form.h"

namespace poinsot {
namespace {

using Eigen::Vector3d;
using Grade = StepJudgement::Grade;

const Vector3d kMoments(1, 2, 3);
const Vector3d kTumbling(0.6, 0.5, 0.7);

Grade gradeOf(const char* method, const Vector3d& moments, const Vector3d& omega, double step) {
  return judgeStep(*findMethod(method), moments, omega, step).grade;
}

TEST(StepLimits, halfATurnAStepIsHopelessForEveryMethodOnABodyThatTumbles) {
  for (const Method& method : freeMethods()) {
    // A composition of order 4 or 6 turns the body 13 or 21 times a step: it loses it later.
    const bool many_turns = std::string(method.name).rfind("splitting", 0) == 0 && method.order > 2;
    for (const double turned : {many_turns ? 8.0 : 4.0, 30.0, 1e3, 1e6, 1e12, 1e100}) {
      const StepJudgement judgement = judgeStep(method, kMoments, kTumbling.normalized(), turned);
      EXPECT_EQ(judgement.grade, Grade::hopeless) << method.name << " " << turned;
      EXPECT_FALSE(judgement.reason.empty());
    }
  }
}

TEST(StepLimits, theStepThatIsNamedInsteadIsSound) {
  Draws draws;
  for (const Method& method : freeMethods()) {
    for (int i = 0; i < 20; ++i) {
      const Vector3d moments = draws.moments(), omega = draws.direction();
      const StepJudgement judgement = judgeStep(method, moments, omega, 5);
      ASSERT_GT(judgement.largest_sound, 0) << method.name;
      EXPECT_LT(judgement.largest_sound, 5) << method.name;
      EXPECT_EQ(judgeStep(method, moments, omega, judgement.largest_sound).grade, Grade::sound) << method.name;
      EXPECT_EQ(judgeStep(method, moments, omega, -judgement.largest_sound).grade, Grade::sound) << method.name;
    }
  }
}

TEST(StepLimits, aStartBesideTheUnstableAxisIsJudgedByItsFlip) {
  // The first turns are all but a steady spin.
  for (const double beside : {1e-2, 1e-8, 1e-140}) {
    EXPECT_EQ(gradeOf("lie_euler", kMoments, {beside, 1, beside}, 4), Grade::hopeless) << beside;
    EXPECT_EQ(gradeOf("buss2", kMoments, {beside, 1, beside}, 4), Grade::hopeless) << beside;
  }
}

TEST(StepLimits, steadySpinsAreFollowedAtAnyStepThatAngleCanBeToldFrom) {
  for (const Vector3d& omega : {Vector3d(0, 0, 1), Vector3d(0, 1, 0), Vector3d(1, 0, 0)}) {
    EXPECT_EQ(gradeOf("lie_euler", kMoments, omega, 2.5), Grade::sound);
    EXPECT_EQ(gradeOf("lie_euler", kMoments, omega, 100), Grade::doubtful);  // right, but aliased
    EXPECT_EQ(gradeOf("lie_euler", kMoments, omega, 1e16), Grade::hopeless);
  }
  EXPECT_EQ(gradeOf("lie_euler", {2, 2, 2}, kTumbling, 100), Grade::doubtful);
}

TEST(StepLimits, aStableSpinThatTheMethodMakesUnstable) {
  // The error of a step is 1e-6 rad, but it grows from step to step.
  EXPECT_EQ(gradeOf("lie_euler", kMoments, {1e-6, 1e-6, 1}, 4), Grade::hopeless);
  // rk4 beyond its limit of stability: the body wobbles 99 times as fast as it turns.
  EXPECT_EQ(gradeOf("rk4", {1, 1, 100}, {1e-6, 0, 1}, 0.03), Grade::hopeless);
  EXPECT_EQ(gradeOf("rk4", {1, 1, 100}, {1e-6, 0, 1}, 0.003), Grade::sound);
}

TEST(StepLimits, nothingIsSaidOfShortSteps) {
  Draws draws;
  for (const Method& method : freeMethods()) {
    for (int i = 0; i < 50; ++i) {
      EXPECT_EQ(judgeStep(method, draws.moments(), draws.direction(), 0.01).grade, Grade::sound) << method.name;
    }
    EXPECT_EQ(judgeStep(method, kMoments, {0, 0, 0}, 1e300).grade, Grade::sound);
    EXPECT_EQ(judgeStep(method, kMoments, {1e-310, 1e-310, 1e-310}, 1e300).grade, Grade::sound);
  }
}

TEST(StepLimits, theScaleOfABodyDoesNotMatter) {
  for (const Method& method : freeMethods()) {
    for (const double step : {0.3, 1.0, 3.0}) {
      const StepJudgement plain = judgeStep(method, kMoments, kTumbling, step);
      for (const int k : {-660, -100, 100, 490}) {
        const double scale = std::ldexp(1, k);
        const StepJudgement scaled = judgeStep(method, kMoments, scale * kTumbling, step / scale);
        EXPECT_EQ(scaled.grade, plain.grade) << method.name << " " << step << " " << k;
        EXPECT_EQ(scaled.reason, plain.reason) << method.name << " " << step << " " << k;
      }
      EXPECT_EQ(judgeStep(method, std::ldexp(1, -900) * kMoments, kTumbling, step).reason, plain.reason);
    }
  }
}

TEST(StepLimits, ratesAreThoseOfTheOrbit) {
  Draws draws;
  for (int i = 0; i < 100; ++i) {
    const Vector3d moments = draws.moments(), omega = draws.direction();
    const OrbitRates rates = orbitRates(moments, omega);
    const ClosedForm orbit(moments, Eigen::Quaterniond::Identity(), omega);
    double most = 0;
    for (int k = 0; k < 4000; ++k) most = std::max(most, orbit.at(k / 4000.0 * orbit.period()).omega_principal.norm());
    EXPECT_LE(most, rates.turn * (1 + 1e-14));
    EXPECT_GE(most, rates.turn * (1 - 1e-3));
  }
  EXPECT_EQ(orbitRates({2, 2, 2}, {3, 0, 4}).wobble, 0);
  EXPECT_DOUBLE_EQ(orbitRates({1, 2, 3}, {0, 0, 1e-200}).turn, 1e-200);
  EXPECT_DOUBLE_EQ(orbitRates({1, 2, 3}, {0, 0, 1e200}).wobble, 2e200);  // 3e200·(1 − 1/3)
}

}  // namespace
}  // namespace poinsot
