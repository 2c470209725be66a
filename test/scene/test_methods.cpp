#include "poinsot/core/stepper.h"
#include "scene_text.h"

using scene_text::body;
using scene_text::expectKeyRefused;
using scene_text::expectRefused;
using scene_text::readBody;

namespace {
const char* const kEveryName[] = {"closed_form", "lie_euler", "buss2",    "buss3",      "buss4",      "rk4",
                                  "rkmk4",       "cf4",       "midpoint", "splitting2", "splitting4", "splitting6",
                                  "dmv2",        "dmv4",      "dmv6",     "dmv8",       "dmv10",      "stepper"};
}

TEST(Method, EveryOneOfTheTableIsAllowed) {
  for (const poinsot::Method& method : poinsot::methods()) {
    const auto brick = readBody({"method: " + std::string(method.name), "step: 0.25"});
    EXPECT_EQ(brick.method, method.name);
    EXPECT_EQ(brick.step, 0.25);
  }
}

TEST(Method, NamesOfOtherVersionsAreToldFromUnknownOnes) {
  int later = 0;
  for (const std::string name : kEveryName) {
    if (poinsot::findMethod(name)) continue;
    ++later;
    expectKeyRefused("method: " + name, ".method",
                     {name + " is not in this version", "allowed: " + poinsot::methodNames()});
  }
  EXPECT_EQ(later + poinsot::methods().size(), std::size(kEveryName));
  expectKeyRefused("method: euler", ".method", {"euler is unknown;", "allowed: " + poinsot::methodNames()});
  expectKeyRefused("method: bus2", ".method", {"bus2 is unknown, did you mean \"buss2\"?", "allowed: "});
  expectKeyRefused("method: RK4", ".method", {"RK4 is unknown, did you mean \"rk4\"?", "allowed: "});
  expectKeyRefused("method: [rk4]", ".method", {"a list of 1 is not a word", "allowed: " + poinsot::methodNames()});
  expectKeyRefused("method:", ".method", {"null is not a word", "allowed: " + poinsot::methodNames()});
}

TEST(Method, ANamedOneNeedsAStep) {
  expectKeyRefused("method: rk4", ".method", {"rk4", "step is missing", "allowed: step, a positive finite number (s)"});
}

TEST(Method, AStepAloneGoesWithTheDefaultMethod) {
  const auto brick = readBody({"step: 1e-3"});
  EXPECT_EQ(brick.method, "buss2");
  EXPECT_EQ(brick.step, 1e-3);
}

TEST(Method, TheStepIsPositive) {
  const std::string allowed = "allowed: a positive finite number (s)";
  expectKeyRefused("step: 0", ".step", {"0 is not positive", allowed});
  expectKeyRefused("step: -1e-3", ".step", {"-1e-3 is not positive", allowed});
  expectKeyRefused("step: .inf", ".step", {".inf is not finite", allowed});
  expectKeyRefused("step: auto", ".step", {"auto is not a decimal number", allowed});
  expectRefused(body({"method: rk4", "step: nan"}), 4, "bodies[0] \"brick\".step", {"nan is not finite", allowed});
}

TEST(Method, AccuracyAndHorizonComeLater) {
  expectKeyRefused("accuracy: 1e-6", ".accuracy", {"accuracy is not in this version", "allowed: method and step"});
  expectKeyRefused("horizon: 600", ".horizon", {"horizon is not in this version", "allowed: method and step"});
}
