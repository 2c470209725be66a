#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "command_line.h"
#include "poinsot/core/method.h"
#include "poinsot/cost/choice.h"
#include "poinsot/cost/method_costs.h"
#include "poinsot/scene/message.h"
#include "poinsot/scene/motion_setup.h"
#include "poinsot/scene/reader.h"
#include "standard_output.h"

namespace {

using namespace poinsot;

constexpr int kNo = 1;
constexpr double kGoodAccuracy = 1e-3, kGoodHorizon = 120;  // rad, s: what makes a stepper good
constexpr double kLeastForSteps = 1.1;  // a budget leaves for steps at least a tenth of what the states cost
// Places of the bodies in a 2×2 arrangement, for a viewer at +x [m].
constexpr double kAcross = 7.6, kUp = 4.2;

const char* const kAbout =
    "Prints a scene: one body four times, side by side, from the same start, under lie_euler, buss2, a good stepper "
    "and the closed form. All steppers cost the same CPU time by nominal costs of the methods, or all take the same "
    "step. The good stepper is the cheapest that keeps to 1e-3 rad for 120 s.";

struct Options {
  std::string scene_file, body, mode = "equal_cost";
  std::optional<double> step = 0.02;  ///< [s], of equal_step
};

/** Returns the keys of a body without name, method and effects. */
YAML::Node bare(const YAML::Node& body) {
  YAML::Node out = YAML::Clone(body);
  for (const char* key : {"name", "method", "step", "accuracy", "horizon", "effects"}) out.remove(key);
  return out;
}

std::size_t indexOf(const scene::Scene& scene, const std::string& name) {
  if (name.empty()) return 0;
  std::vector<std::string> names;
  for (const scene::Body& body : scene.bodies) names.push_back(body.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw tools::BadUse("--body", "one of " + scene::joined(names), '"' + name + '"');
  return static_cast<std::size_t>(found - names.begin());
}

/** Returns the cheapest stepper for a good accuracy of the free body, which is what is compared: without its effects.
 */
cost::Choice goodStepper(MotionSetup setup, double rate, const cost::MethodCosts& costs) {
  setup.effects.clear();
  std::vector<std::string> candidates;
  for (const Method& method : freeMethods()) {
    const std::string name = method.name;
    if (name != "lie_euler" && name != "buss2") candidates.push_back(name);
  }
  return cost::choose(setup, {kGoodAccuracy, kGoodHorizon, rate, candidates}, costs);
}

void print(const Options& options) {
  const YAML::Node tree = scene::readDocument(options.scene_file);
  const scene::Scene scene = scene::readTree(tree, options.scene_file);
  const std::size_t index = indexOf(scene, options.body);
  const scene::Body& body = scene.bodies[index];
  const double rate = scene.rate.value_or(scene::kDefaultRate);
  const cost::MethodCosts& costs = cost::nominalCosts();
  const cost::Choice good = goodStepper(scene::motionSetup(body), rate, costs);
  const std::vector<std::string> steppers = {"lie_euler", "buss2", good.method};

  // All steppers may cost as much as the good one, or more if one of them would have too little left for its steps.
  double budget = good.cost;
  for (const std::string& name : steppers) budget = std::max(budget, kLeastForSteps * rate * costs.of(name).per_state);
  const auto stepOf = [&](const std::string& name) {
    const cost::MethodCost& cost = costs.of(name);
    return options.mode == "equal_step" ? *options.step : cost.per_step / (budget - rate * cost.per_state);
  };

  YAML::Emitter out;
  out.SetDoublePrecision(17);
  const auto comment = [&](const char* format, double a, double b) {
    char text[200];
    std::snprintf(text, sizeof text, format, a, b);
    return std::string(text);
  };
  out << YAML::Comment(
      options.mode == "equal_step"
          ? comment("Made by compare_scene: every step is %g s, at %g states a second.", *options.step, rate)
          : comment("Made by compare_scene: every stepper costs a nominal %.3g us of CPU per simulated second, "
                    "at %g states a second.",
                    1e6 * budget, rate));
  out << YAML::BeginMap << YAML::Key << "rate" << YAML::Value << rate << YAML::Key << "bodies" << YAML::Value
      << YAML::BeginSeq;
  const YAML::Node given = bare(tree["bodies"][index]);
  std::vector<std::string> names = steppers;
  names.push_back(kClosedForm);
  for (std::size_t i = 0; i < names.size(); ++i) {
    YAML::Node one = YAML::Clone(given);
    one["name"] = names[i];
    one["method"] = names[i];
    if (names[i] != kClosedForm) one["step"] = stepOf(names[i]);
    YAML::Node place;
    place["type"] = "translation";
    place["position"] = std::vector<double>{0, (i % 2 == 0 ? -1 : 0) * kAcross, (i < 2 ? 0.5 : -0.5) * kUp};
    one["effects"].push_back(place);
    out << one;
    out << YAML::Comment(
        comment("costs %.3g us per simulated second, %.3g of them for steps",
                1e6 * costs.perSimulatedSecond(names[i], names[i] == kClosedForm ? 1 : stepOf(names[i]), rate),
                names[i] == kClosedForm ? 0 : 1e6 * costs.of(names[i]).per_step / stepOf(names[i])));
  }
  out << YAML::EndSeq << YAML::EndMap;
  const std::string text = std::string(out.c_str()) + "\n";
  scene::readTree(YAML::Load(text), "the scene to compare");  // refuses a step that the node would refuse
  std::cout << text;
  tools::flushStandardOutput();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(kAbout, "compare_scene");
  Options options;
  app.add_option("scene", options.scene_file, "A scene file that holds the body")->required();
  app.add_option("--body", options.body, "Which of its bodies (default: the first)");
  app.add_option("--mode", options.mode, "What all steppers have in common")
      ->check(tools::oneOf({"equal_cost", "equal_step"}))
      ->capture_default_str();
  tools::addPositive(app, "--step", options.step, "s", "With equal_step: every step [s]");
  if (const auto code = tools::parse(app, argc, argv)) return *code;
  return tools::exitCodeOf<cost::Unreachable>("compare_scene", kNo, tools::kBadUse, [&] { print(options); });
}
