#include "poinsot/core/method.h"
#include "scene_text.h"

using scene_text::body;
using scene_text::expectKeyRefused;
using scene_text::expectRefused;
using scene_text::read;
using scene_text::readBody;

namespace {

std::string allNames() {
  return "closed_form, " + poinsot::methodNames(poinsot::freeMethods()) + ", stepper";
}

/** expectRefused for the step of a body of these lines, the last of them `step`. */
void expectStepRefused(const std::vector<std::string>& lines, const std::vector<std::string>& pieces) {
  const int line = scene_text::kFirstLine + static_cast<int>(lines.size()) - 1;
  expectRefused(body(lines), line, "bodies[0] \"brick\".step", pieces);
}

}  // namespace

TEST(Method, TheClosedFormIsTheDefault) {
  for (const auto& brick : {readBody({}), readBody({"method: closed_form"})}) {
    EXPECT_EQ(brick.method, "closed_form");
    EXPECT_FALSE(brick.step);
  }
}

TEST(Method, EveryOneOfTheTableIsAllowed) {
  for (const poinsot::Method& method : poinsot::freeMethods()) {
    const auto brick = readBody({"method: " + std::string(method.name), "step: 0.0078125"});
    EXPECT_EQ(brick.method, method.name);
    EXPECT_EQ(brick.step.value(), 0.0078125);
  }
}

TEST(Method, UnknownOnesAreRefused) {
  expectKeyRefused("method: euler", ".method",
                   {"got \"euler\" (did you mean \"lie_euler\"?)$", "expected one of " + allNames() + ", got"});
  expectKeyRefused("method: bus2", ".method", {"got \"bus2\" (did you mean \"buss2\"?)$"});
  expectKeyRefused("method: RK4", ".method", {"got \"RK4\" (did you mean \"rk4\"?)$"});
  expectKeyRefused("method: closed", ".method", {"got \"closed\"$"});
  expectKeyRefused("method: closedform", ".method", {" (did you mean \"closed_form\"?)$"});
  expectKeyRefused("method: [rk4]", ".method", {"got a list of 1$", "expected one of " + allNames() + ", got"});
  expectKeyRefused("method:", ".method", {"got null$", "expected one of " + allNames() + ", got"});
}

TEST(Method, AStepperNeedsAStep) {
  expectKeyRefused("method: rk4", ".method",
                   {"expected the key step beside it, a positive finite number (s), got none: rk4 goes in steps"});
}

TEST(Method, TheClosedFormTakesNoStep) {
  const std::string expected =
      "expected no step, or one beside a method that steps (" + poinsot::methodNames(poinsot::freeMethods()) + "), got";
  expectStepRefused({"step: 1e-3"}, {"got a step without a method, which means closed_form$", expected});
  expectStepRefused({"method: closed_form", "step: 1e-3"}, {"got a step beside closed_form$", expected});
}

TEST(Method, TheStepIsPositive) {
  const std::string expected = "expected a positive finite number (s)";
  expectStepRefused({"method: rk4", "step: 0"}, {"got 0$", expected});
  expectStepRefused({"method: rk4", "step: -1e-3"}, {"got -1e-3$", expected});
  expectStepRefused({"method: rk4", "step: .inf"}, {"got .inf$", expected});
  expectStepRefused({"method: rk4", "step: nan"}, {"got \"nan\"$", expected});
  expectStepRefused({"method: rk4", "step: auto"}, {"got \"auto\": not a decimal number$", expected});
}

TEST(Method, AStepAtWhichItDoesNotFollowTheBodyIsRefused) {
  // 10 rad a step.
  for (const poinsot::Method& method : poinsot::freeMethods()) {
    SCOPED_TRACE(method.name);
    const std::string name = method.name;
    expectStepRefused({"angular_velocity: [60, 80, 0]", "method: " + name, "step: 0.1"},
                      {name + " with a step of 0.1 s at |Omega| = 100 rad/s: ", "expected a step of at most ",
                       "or closed_form, which has no step"});
    EXPECT_TRUE(read(body({"angular_velocity: [60, 80, 0]", "method: " + name, "step: 1e-5"})).warnings.empty());
    EXPECT_TRUE(read(body({"angular_velocity: [0, 0, 0]", "method: " + name, "step: 0.1"})).warnings.empty());
  }
}

TEST(Method, AStepThatIsDoubtfulMakesAWarning) {
  const scene_text::TemporaryFile file(body({"angular_velocity: [0.6, 0.8, 0]", "method: lie_euler", "step: 0.15"}));
  const auto scene = poinsot::scene::readFile(file.path());
  ASSERT_EQ(scene.warnings.size(), 1u);
  const std::string& warning = scene.warnings[0];
  EXPECT_EQ(
      warning.rfind(file.path() + ":5: bodies[0] \"brick\".step: lie_euler with a step of 0.15 s at |Omega| = 1 ", 0),
      0u)
      << warning;
  EXPECT_NE(warning.find("closed_form, which has no step"), std::string::npos) << warning;
}

TEST(Method, TheSuggestedStepIsGood) {
  for (const poinsot::Method& method : poinsot::freeMethods()) {
    const std::string name = method.name;
    try {
      read(body({"angular_velocity: [60, 80, 0]", "method: " + name, "step: 0.1"}));
      ADD_FAILURE() << name << " was accepted";
    } catch (const poinsot::scene::Error& error) {
      const std::string what = error.what(), before = "a step of at most ";
      const std::size_t at = what.find(before);
      ASSERT_NE(at, std::string::npos) << what;
      const std::string step =
          what.substr(at + before.size(), what.find(" s", at + before.size()) - at - before.size());
      const auto scene = read(body({"angular_velocity: [60, 80, 0]", "method: " + name, "step: " + step}));
      EXPECT_TRUE(scene.warnings.empty()) << step << ": " << scene.warnings.front();
    }
  }
}

namespace {

/** The candidates of a body of these lines. */
std::vector<std::string> candidates(const std::vector<std::string>& lines) {
  return readBody(lines).accuracy.value().candidates;
}

}  // namespace

TEST(Accuracy, IsReadWithItsHorizon) {
  const auto brick = readBody({"accuracy: 1e-6", "horizon: 600"});
  ASSERT_TRUE(brick.accuracy);
  EXPECT_EQ(brick.accuracy->error, 1e-6);
  EXPECT_EQ(brick.accuracy->horizon, 600);
  EXPECT_FALSE(brick.step);
  EXPECT_FALSE(readBody({}).accuracy);
}

TEST(Accuracy, ChoosesAmongTheMethodsThatTheSceneLeavesOpen) {
  std::vector<std::string> steppers;
  for (const poinsot::Method& method : poinsot::freeMethods()) steppers.push_back(method.name);
  std::vector<std::string> all = steppers;
  all.insert(all.begin(), "closed_form");
  EXPECT_EQ(candidates({"accuracy: 1e-6", "horizon: 600"}), all);
  EXPECT_EQ(candidates({"method: stepper", "accuracy: 1e-6", "horizon: 600"}), steppers);
  EXPECT_EQ(candidates({"method: dmv8", "accuracy: 1e-6", "horizon: 600"}), std::vector<std::string>{"dmv8"});
  EXPECT_EQ(candidates({"method: closed_form", "accuracy: 1e-6", "horizon: 600"}),
            std::vector<std::string>{"closed_form"});
}

TEST(Accuracy, NeedsAHorizonAndExcludesAStep) {
  expectRefused(body({"accuracy: 1e-6"}), scene_text::kFirstLine - 1, "bodies[0] \"brick\"",
                {"expected the key horizon, ", "a positive finite number (s)"});
  expectKeyRefused("horizon: 600", ".horizon",
                   {"expected the key accuracy beside it, a positive finite number (rad), got none"});
  expectStepRefused({"accuracy: 1e-6", "horizon: 600", "step: 0.1"},
                    {"expected one of the keys accuracy, step, got both"});
  expectKeyRefused("method: stepper", ".method",
                   {"expected the keys accuracy and horizon beside it, or one of ", "got \"stepper\" alone"});
}

TEST(Accuracy, HoldsAtLeastAsLongAsTheProgramLooks) {
  const auto horizon = [](const std::vector<std::string>& lines) {
    const scene_text::TemporaryFile file(body(lines));
    return poinsot::scene::readFile(file.path(), {30.0}).bodies.at(0).accuracy.value().horizon;
  };
  EXPECT_EQ(horizon({"accuracy: 1e-6"}), 30);
  EXPECT_EQ(horizon({"accuracy: 1e-6", "horizon: 5"}), 30);
  EXPECT_EQ(horizon({"accuracy: 1e-6", "horizon: 600"}), 600);
  EXPECT_THROW(horizon({"accuracy: 1e-6", "horizon: 0"}), poinsot::scene::Error);
  EXPECT_THROW(horizon({"horizon: 600"}), poinsot::scene::Error);
}

TEST(Accuracy, IsAPositiveAngle) {
  for (const char* bad : {"0", "-1e-6", ".nan", "fine"}) {
    expectRefused(body({"horizon: 600", "accuracy: " + std::string(bad)}), scene_text::kFirstLine + 1,
                  "bodies[0] \"brick\".accuracy", {"expected a positive finite number (rad)"});
  }
  expectRefused(body({"horizon: 600", "accuracy: 1.5"}), scene_text::kFirstLine + 1, "bodies[0] \"brick\".accuracy",
                {"expected a positive number up to 1 (rad), got 1.5: "});
  expectRefused(body({"accuracy: 1e-6", "horizon: 0"}), scene_text::kFirstLine + 1, "bodies[0] \"brick\".horizon",
                {"got 0$", "expected a positive finite number (s)"});
}
