// Whether a choice keeps its accuracy and is the cheapest, judged by trying every method and step.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "exhaustive.h"
#include "poinsot/core/method.h"
#include "poinsot/cost/choice.h"

using namespace poinsot;

namespace {

// Costs as they are on some machine [s]: a test must not depend on this one.
const std::map<std::string, cost::MethodCost> kCosts = {
    {"closed_form", {100e-9, 0}},    {"lie_euler", {150e-9, 21e-9}},   {"buss2", {150e-9, 26e-9}},
    {"buss3", {170e-9, 44e-9}},      {"buss4", {190e-9, 65e-9}},       {"rk4", {190e-9, 90e-9}},
    {"rkmk4", {230e-9, 109e-9}},     {"cf4", {250e-9, 126e-9}},        {"midpoint", {380e-9, 260e-9}},
    {"splitting2", {210e-9, 85e-9}}, {"splitting4", {410e-9, 275e-9}}, {"splitting6", {520e-9, 403e-9}},
    {"dmv2", {190e-9, 72e-9}},       {"dmv4", {230e-9, 73e-9}},        {"dmv6", {270e-9, 71e-9}},
    {"dmv8", {310e-9, 71e-9}},       {"dmv10", {330e-9, 73e-9}}};

constexpr double kRate = 60, kHorizon = 100;

double costOf(const std::string& method, double step, double rate) {
  const cost::MethodCost& cost = kCosts.at(method);
  return rate * cost.per_state + (cost.per_step > 0 ? cost.per_step / step : 0);
}

std::vector<std::string> steppers() {
  std::vector<std::string> names;
  for (const Method& method : freeMethods()) names.push_back(method.name);
  return names;
}

std::vector<std::string> everything() {
  std::vector<std::string> names = steppers();
  names.push_back(kClosedForm);
  return names;
}

cost::Choice choose(const MotionSetup& setup, double accuracy, const std::vector<std::string>& candidates,
                    double horizon = kHorizon, double rate = kRate) {
  return cost::choose(setup, {accuracy, horizon, rate, candidates}, cost::MethodCosts(kCosts));
}

/** The error of what was chosen, at times that are no ticks. */
double trueError(MotionSetup setup, const cost::Choice& choice, double horizon = kHorizon) {
  setup.method = choice.method;
  setup.step = choice.step;
  return exhaustive::errorAt(setup, exhaustive::randomTimes(horizon, 2000, 11), 10);
}

MotionSetup body(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega) {
  MotionSetup setup;
  setup.inertia = PrincipalInertia::fromMoments(moments);
  setup.omega_body = omega;
  return setup;
}

TEST(Choice, theCostModelIsPerStateAndPerStep) {
  const cost::MethodCosts costs(kCosts);
  EXPECT_DOUBLE_EQ(costs.perSimulatedSecond("closed_form", 0, 60), 6e-6);
  EXPECT_DOUBLE_EQ(costs.perSimulatedSecond("dmv8", 0.01, 60), 60 * 310e-9 + 100 * 71e-9);
  EXPECT_THROW(costs.perSimulatedSecond("euler", 0.01, 60), std::out_of_range);
}

TEST(Choice, keepsItsWordAndIsNoMoreThanTwiceAsDearAsTheCheapest) {
  for (const MotionSetup& setup : exhaustive::randomBodies(4, 1)) {
    for (const double accuracy : {1e-1, 1e-4, 1e-7, 1e-11}) {
      SCOPED_TRACE(accuracy);
      const cost::Choice choice = choose(setup, accuracy, steppers());
      EXPECT_NE(choice.method, kClosedForm);
      EXPECT_LE(choice.verified_error, accuracy);
      EXPECT_LE(trueError(setup, choice), accuracy);
      EXPECT_DOUBLE_EQ(choice.cost, costOf(choice.method, *choice.step, kRate));
      double cheapest = choice.cost;
      for (const auto& way : exhaustive::waysToKeep(setup, accuracy, kHorizon, kRate, costOf, choice.cost)) {
        cheapest = std::min(cheapest, costOf(way.method, way.step, kRate));
      }
      EXPECT_LE(choice.cost, 1.25 * cheapest) << choice.method << " " << *choice.step;
    }
  }
}

TEST(Choice, theClosedFormWhereItIsAllowedAndCheapest) {
  for (const MotionSetup& setup : exhaustive::randomBodies(5, 2)) {
    for (const double accuracy : {1e-1, 1e-13}) {
      const cost::Choice choice = choose(setup, accuracy, everything());
      EXPECT_EQ(choice.method, kClosedForm);
      EXPECT_FALSE(choice.step);
      EXPECT_LE(choice.verified_error, 2e-15);
    }
  }
}

TEST(Choice, aStepperWhereItIsCheaperThanTheClosedForm) {
  auto costs = kCosts;
  costs["closed_form"].per_state = 1e-3;
  const MotionSetup setup = body({1, 2, 3}, {0.6, 0.5, 0.7});
  const cost::Choice choice = cost::choose(setup, {1e-6, kHorizon, kRate, everything()}, cost::MethodCosts(costs));
  EXPECT_NE(choice.method, kClosedForm);
  EXPECT_LE(trueError(setup, choice), 1e-6);
}

TEST(Choice, ofOneMethodOnlyTheStep) {
  const MotionSetup setup = body({1, 2, 3}, {0.6, 0.5, 0.7});
  const double horizon = 10;
  for (const std::string& name : steppers()) {
    SCOPED_TRACE(name);
    const double accuracy = findMethod(name)->order <= 2 ? 1e-3 : 1e-8;
    const cost::Choice choice = choose(setup, accuracy, {name}, horizon);
    EXPECT_EQ(choice.method, name);
    EXPECT_LE(trueError(setup, choice, horizon), accuracy);
    // A step half as long again is too long: the choice is not merely safe.
    cost::Choice longer = choice;
    *longer.step *= 1.6;
    EXPECT_GT(trueError(setup, longer, horizon), accuracy);
  }
}

TEST(Choice, hardBodies) {
  const struct {
    const char* name;
    MotionSetup setup;
  } cases[] = {{"separatrix", body({2, 5, 6}, {0.5, 0.3, 0.5})},
               {"near the unstable axis", body({1, 2, 3}, {1e-8, 1, 1e-8})},
               {"sphere", body({2, 2, 2}, {1, 2, 3})},
               {"nearly symmetric", body({1, 1 + 1e-12, 2}, {0.3, 0.4, 1})},
               {"extreme ratio", body({1, 1e3, 1e3 + 0.5}, {0.6, 0.5, 0.7})},
               {"spin", body({1, 2, 3}, {0, 0, 2})},
               {"rest", body({1, 2, 3}, {0, 0, 0})},
               {"fast", body({1, 2, 3}, {600, 500, 700})}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.name);
    const double horizon = 20;
    const cost::Choice choice = choose(c.setup, 1e-6, steppers(), horizon);
    EXPECT_LE(choice.verified_error, 1e-6);
    EXPECT_LE(trueError(c.setup, choice, horizon), 1e-6) << choice.method << " " << *choice.step;
  }
}

/** The message of a refusal; empty where something was chosen. */
std::string refusal(const MotionSetup& setup, double accuracy, const std::vector<std::string>& candidates,
                    double horizon) {
  try {
    choose(setup, accuracy, candidates, horizon);
  } catch (const cost::Unreachable& error) {
    return error.what();
  }
  return "";
}

TEST(Choice, refusesWhatCannotBeReached) {
  const MotionSetup setup = body({1, 2, 3}, {0.6, 0.5, 0.7});
  const std::string rounding = refusal(setup, 1e-14, steppers(), 1e4);
  EXPECT_NE(rounding.find("keeps to 1e-14 rad for 1e+04 s"), std::string::npos) << rounding;
  EXPECT_NE(rounding.find("rounding prevents a smaller error"), std::string::npos) << rounding;
  for (const auto& candidates : {everything(), steppers(), {kClosedForm}}) {
    const std::string beyond = refusal(setup, 1e-15, candidates, 1);
    EXPECT_NE(beyond.find("the closed form, by which accuracies are verified, is itself known to 2e-15 rad only"),
              std::string::npos)
        << beyond;
  }
  const std::string too_long = refusal(setup, 1e-10, {"lie_euler"}, 1e5);
  EXPECT_NE(too_long.find("lie_euler does not keep to 1e-10 rad for 1e+05 s"), std::string::npos) << too_long;
  EXPECT_NE(too_long.find("within 5e+07 steps"), std::string::npos) << too_long;
}

TEST(Exhaustive, itsErrorSeesAWrongStep) {
  MotionSetup setup = body({1, 2, 3}, {0.6, 0.5, 0.7});
  setup.method = "lie_euler";
  setup.step = 0.1;
  EXPECT_GT(exhaustive::errorAt(setup, exhaustive::randomTimes(kHorizon, 100, 3), 10), 0.1);
}

}  // namespace
