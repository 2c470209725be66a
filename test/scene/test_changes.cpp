// What may be changed of a body while it is shown is held to what a scene file is held to.
#include "poinsot/scene/changes.h"

#include <cmath>

#include "poinsot/core/method.h"
#include "poinsot/scene/motion_setup.h"
#include "scene_text.h"

namespace {

using poinsot::Motion;
using poinsot::scene::Body;
using scene_text::readBody;

const std::vector<std::string> kHeavy = {
    "effects: [{type: gravity_torque, mass: 1, gravity: [0, 0, -9.81], centre_of_mass: [0, 0, 0.3]}]"};

template <class Change>
void expectRefused(const Change& change, const std::vector<std::string>& pieces) {
  try {
    change();
  } catch (const poinsot::scene::Error& error) {
    for (const std::string& piece : pieces) {
      EXPECT_NE(std::string(error.what()).find(piece), std::string::npos) << piece << "\n" << error.what();
    }
    return;
  }
  ADD_FAILURE() << "accepted; expected a refusal with " << pieces.front();
}

TEST(Changes, MethodsOfAFreeBodyAreAllOfThem) {
  const auto names = methodsFor(readBody({}));
  EXPECT_EQ(names.size(), poinsot::freeMethods().size() + 1);
  EXPECT_EQ(names.front(), "closed_form");
}

TEST(Changes, MethodsUnderTorquesLeaveTheClosedFormOut) {
  const auto names = methodsFor(readBody(kHeavy));
  ASSERT_FALSE(names.empty());
  for (const std::string& name : names) EXPECT_NE(name, "closed_form");
}

TEST(Changes, EveryMethodGetsAStepAtWhichItMovesTheBody) {
  for (const Body& body : {readBody({}), readBody(kHeavy), readBody({"angular_velocity: [0, 0, 0]"}),
                           readBody({"angular_velocity: [1e4, 1, 3e3]"})}) {
    for (const std::string& method : methodsFor(body)) {
      std::vector<std::string> warnings;
      const Body changed = withMethod(body, method, std::nullopt, warnings);
      EXPECT_EQ(changed.method, method);
      EXPECT_TRUE(warnings.empty()) << warnings.front();
      Motion motion(poinsot::scene::motionSetup(changed));
      const double t = changed.step ? 10 * *changed.step : 1;
      EXPECT_TRUE(motion.at(t).omega_body.allFinite());
    }
  }
}

TEST(Changes, TheStepThatIsGivenIsTaken) {
  std::vector<std::string> warnings;
  EXPECT_EQ(withMethod(readBody({}), "rk4", 0.0078125, warnings).step.value(), 0.0078125);
  EXPECT_FALSE(withMethod(readBody({}), "closed_form", 0.1, warnings).step);
}

TEST(Changes, BadMethodsAndStepsAreRefused) {
  std::vector<std::string> warnings;
  const Body body = readBody({});
  expectRefused([&] { withMethod(body, "rk5", std::nullopt, warnings); },
                {"body \"brick\"", "rk5", "expected one of the methods that move this body, closed_form, "});
  expectRefused([&] { withMethod(readBody(kHeavy), "closed_form", std::nullopt, warnings); },
                {"closed_form", "taylor"});
  for (const double step : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    expectRefused([&] { withMethod(body, "rk4", step, warnings); },
                  {"expected a positive finite number (s) as step, got "});
  }
  const Body tumbling = readBody({"angular_velocity: [0.1, 1, 0.1]"});
  expectRefused([&] { withMethod(tumbling, "lie_euler", 50, warnings); },
                {"lie_euler with a step of 50 s", "a step of at most"});
}

TEST(Changes, ASpinStartsWhereTheBodyIs) {
  const Body body = readBody(
      {"effects: [{type: translation, position: [1, 2, 3], velocity: [0, 0, 5], acceleration: [0, 0, -9.81]}]"});
  Motion motion(poinsot::scene::motionSetup(body));
  const poinsot::MotionState now = motion.at(0.7);
  const Eigen::Vector3d omega(0.3, -0.2, 1);
  Motion changed(poinsot::scene::motionSetup(withSpin(body, now, omega)));
  const poinsot::MotionState start = changed.at(0);
  EXPECT_NEAR(start.attitude.angularDistance(now.attitude), 0, 1e-15);
  EXPECT_NEAR((start.omega_body - omega).norm(), 0, 1e-15);
  EXPECT_EQ(start.position, now.position);
  EXPECT_EQ(start.velocity, now.velocity);
  EXPECT_NEAR((changed.at(0.2).position - motion.at(0.9).position).norm(), 0, 1e-14) << "it flies on";
}

TEST(Changes, ForbiddenSpinsAreRefused) {
  const Body body = readBody({});
  const poinsot::MotionState now = Motion(poinsot::scene::motionSetup(body)).at(0);
  for (const double bad : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    expectRefused(
        [&] {
          withSpin(body, now, {1, bad, 0});
        },
        {"body \"brick\"", "not finite", "expected 3 finite numbers"});
  }
  expectRefused([&] { withSpin(body, now, {1e200, 0, 0}); }, {"expected 3 finite numbers"});
  expectRefused([&] { withSpin(body, now, {1e-200, 0, 0}); }, {"expected 3 finite numbers"});
  EXPECT_EQ(withSpin(body, now, Eigen::Vector3d::Zero()).omega_body.norm(), 0) << "rest is allowed";
  const Body stepped = readBody({"method: rk4", "step: 0.01"});
  expectRefused([&] { withSpin(stepped, now, {0, 1000, 1}); }, {"rk4 with a step of 0.01 s", "a step of at most"});
}

TEST(Changes, TheOldStartComesBackAlsoWhereTheStepIsTooLongForIt) {
  const Body original = readBody({"angular_velocity: [0.1, 10, 0.1]"});
  std::vector<std::string> warnings;
  const poinsot::MotionState now = Motion(poinsot::scene::motionSetup(original)).at(3);
  Body slow = withSpin(original, now, {0, 0.001, 0});
  slow = withMethod(slow, "rk4", 2.0, warnings);
  const Body back = withStartOf(slow, original);
  EXPECT_EQ(back.omega_body, original.omega_body);
  EXPECT_EQ(back.attitude.coeffs(), original.attitude.coeffs());
  EXPECT_EQ(back.method, "closed_form");
  slow = withMethod(slow, "rk4", 0.001, warnings);
  EXPECT_EQ(withStartOf(slow, original).method, "rk4") << "a method that follows it stays";
}

}  // namespace
