// Whether a choice under torques keeps its accuracy and is among the cheapest, judged by trying methods and steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "exhaustive.h"
#include "poinsot/core/method.h"
#include "poinsot/core/rotation.h"
#include "poinsot/cost/choice.h"
#include "poinsot/cost/method_costs.h"
#include "poinsot/cost/resolve_accuracy.h"
#include "poinsot/scene/reader.h"

using namespace poinsot;

namespace {

constexpr double kRate = 60, kHorizon = 20;

MotionSetup body(const std::vector<Effect>& effects) {
  MotionSetup setup;
  setup.inertia = PrincipalInertia::fromMoments({1, 1.7, 2.1});
  setup.attitude = Eigen::Quaterniond(0.5, -0.1, 0.7, 0.3).normalized();
  setup.omega_body = {0.6, -0.5, 0.7};
  setup.effects = effects;
  return setup;
}

const std::vector<std::vector<Effect>>& kinds() {
  static const std::vector<std::vector<Effect>> all = {
      {GravityTorque{1, {0, 0, -2}, {0.1, -0.2, 0.4}}},
      {GravityTorque{1e-3, {0, 0, -2}, {0.1, -0.2, 0.4}}},  // weak
      {ViscousDamping{{0.1, 0.2, 0.15}}, ConstantTorque{Axes::body, {0.1, 0, 0.2}}},
      {TorqueSchedule{{{1.1, 2.3, Axes::body, {1, 0, 2}}, {7.7, 9, Axes::world, {0, -1, 0}}}}}};
  return all;
}

std::vector<std::string> candidates(const MotionSetup& setup) {
  std::vector<std::string> names;
  for (const Method& method : torquedMethods()) {
    if (objectionTo(method, sumOf(setup.inertia, setup.effects)).empty()) names.push_back(method.name);
  }
  return names;
}

cost::Choice choose(const MotionSetup& setup, double accuracy, double horizon = kHorizon) {
  return cost::choose(setup, {accuracy, horizon, kRate, candidates(setup)}, cost::nominalCosts());
}

double costOf(const std::string& method, double step) {
  return cost::nominalCosts().perSimulatedSecond(cost::costName(method, true), step, kRate);
}

/** Against taylor24 at a step that is short for it, at times that are no ticks; infinite where there is no state. */
double trueError(MotionSetup setup, const std::string& method, double step, double horizon = kHorizon) {
  MotionSetup fine = setup;
  fine.method = "taylor24";
  fine.step = 0.11;
  setup.method = method;
  setup.step = step;
  Motion motion(setup), truth(fine);
  double worst = 0;
  try {
    for (const double t : exhaustive::randomTimes(horizon, 100, 7)) {
      const MotionState a = motion.at(t), b = truth.at(t);
      worst = std::max({worst, angleBetween(a.attitude, b.attitude)});
    }
  } catch (const std::runtime_error&) {
    return std::numeric_limits<double>::infinity();
  }
  return worst;
}

TEST(TorqueChoice, keepsItsWordAndIsNoMoreThanTwiceAsDearAsTheCheapest) {
  for (const auto& effects : kinds()) {
    const MotionSetup setup = body(effects);
    for (const double accuracy : {1e-2, 1e-5, 1e-9, 1e-12}) {
      const cost::Choice choice = choose(setup, accuracy);
      const std::string what = nameOf(effects[0]) + " " + choice.method + " " + std::to_string(*choice.step);
      EXPECT_LE(choice.verified_error, accuracy) << what;
      EXPECT_LE(trueError(setup, choice.method, *choice.step), accuracy) << what;
      EXPECT_DOUBLE_EQ(choice.cost, costOf(choice.method, *choice.step));
      double cheapest = choice.cost;
      for (const std::string& method : candidates(setup)) {
        for (double step = 4; costOf(method, step) < 0.5 * choice.cost; step *= 0.85) {
          if (trueError(setup, method, step) > accuracy) continue;
          cheapest = std::min(cheapest, costOf(method, step));
          ADD_FAILURE() << what << ": " << method << " at " << step << " costs " << costOf(method, step) << ", not "
                        << choice.cost;
        }
      }
      std::printf("%-18s %.0e: %-8s step %-9.4g error %.1e, %.2f us/s\n", nameOf(effects[0]).c_str(), accuracy,
                  choice.method.c_str(), *choice.step, choice.verified_error, 1e6 * choice.cost);
    }
  }
}

// A torque that is zero at the start does not hide what is to come.
TEST(TorqueChoice, startsThatTellNothing) {
  const struct {
    const char* name;
    MotionSetup setup;
  } cases[] = {
      {"an upright pendulum", body({GravityTorque{1, {0, 0, 9.8}, {1e-3, 0, -1}}})},
      {"a thruster that waits", body({TorqueSchedule{{{5, 12, Axes::body, {0.3, 0, 0.4}}}}})},
      {"an orbit, aligned", body({GravityGradient{2, {0, 0, 1}, {0, 1, 0}}})},
      {"hanging still", body({GravityTorque{1, {0, 0, -1}, {0, 0, -1}}})},
  };
  for (const auto& c : cases) {
    MotionSetup setup = c.setup;
    setup.attitude.setIdentity();
    setup.omega_body.setZero();
    const cost::Choice choice = choose(setup, 1e-8);
    EXPECT_LE(choice.verified_error, 1e-8) << c.name;
    EXPECT_LE(trueError(setup, choice.method, *choice.step), 1e-8)
        << c.name << " " << choice.method << " " << *choice.step;
  }
}

/** The message of a refusal; empty where something was chosen. */
std::string refusal(const MotionSetup& setup, double accuracy, double horizon) {
  try {
    choose(setup, accuracy, horizon);
  } catch (const cost::Unreachable& error) {
    return error.what();
  }
  return "";
}

TEST(TorqueChoice, whatCannotBeVerifiedIsRefused) {
  // A heavy body that tumbles over its pivot is chaotic: rounding grows by e in a second or so.
  MotionSetup chaotic = body({GravityTorque{1, {0, 0, -9.8}, {0.3, -0.4, 0.6}}});
  chaotic.omega_body = {1, 3, -2};
  const std::string sensitive = refusal(chaotic, 1e-6, 500);
  EXPECT_NE(sensitive.find("two references differ by"), std::string::npos) << sensitive;
  EXPECT_NE(sensitive.find("very sensitive motion"), std::string::npos) << sensitive;
  EXPECT_EQ(refusal(chaotic, 1e-6, 5), "");

  const std::string beyond = refusal(body(kinds()[0]), 1e-17, kHorizon);
  EXPECT_NE(beyond.find("cannot be verified"), std::string::npos) << beyond;

  MotionSetup fast = body(kinds()[0]);
  fast.omega_body *= 1e7;
  const std::string long_run = refusal(fast, 1e-6, 1e4);
  EXPECT_NE(long_run.find("more than 2e+07 steps"), std::string::npos) << long_run;
}

const std::string kChaotic =
    "bodies: [{name: top, inertia: [1, 1.7, 2.1], angular_velocity: [1, 3, -2], "
    "effects: [{type: gravity_torque, mass: 1, centre_of_mass: [0.3, -0.4, 0.6]}]";

TEST(TorqueChoice, aSceneThatNamesNoAccuracyIsMovedAsWellAsCanBeAndOneThatDoesIsRefused) {
  scene::ReadOptions options;
  options.horizon = 500;
  scene::Scene scene = scene::readTree(YAML::Load(kChaotic + "}]"), "tree", options);
  const std::vector<std::string> said = cost::resolveAccuracies(scene, kRate);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("the best that doubles allow for a very sensitive motion"), std::string::npos) << said[0];
  EXPECT_EQ(scene.bodies[0].method, "taylor24");
  EXPECT_TRUE(scene.bodies[0].step);

  scene = scene::readTree(YAML::Load(kChaotic + ", accuracy: 1e-6}]"), "tree", options);
  try {
    cost::resolveAccuracies(scene, kRate);
    ADD_FAILURE() << "accepted";
  } catch (const scene::Error& error) {
    const std::string what = error.what();
    EXPECT_NE(
        what.find("bodies[0] \"top\".accuracy: expected a larger accuracy or a shorter horizon, got 1e-06 rad for "
                  "500 s: two references differ by"),
        std::string::npos)
        << what;
  }
}

TEST(TorqueChoice, isTheSameEveryTime) {
  for (const auto& effects : kinds()) {
    const cost::Choice a = choose(body(effects), 1e-7), b = choose(body(effects), 1e-7);
    EXPECT_EQ(a.method, b.method);
    EXPECT_EQ(a.step, b.step);
  }
}

}  // namespace
