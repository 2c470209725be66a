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
#include "poinsot/ros/scene_list.h"
#include "poinsot/scene/message.h"
#include "poinsot/scene/motion_setup.h"
#include "poinsot/scene/reader.h"
#include "standard_output.h"

namespace {

using namespace poinsot;

constexpr int kNo = 1;
constexpr double kGoodAccuracy = 1e-3, kGoodHorizon = 120;  // rad, s: what makes a stepper good
constexpr double kLeastForSteps = 1.1;  // a budget leaves for steps at least a tenth of what the states cost
// From one body to the next, in radii of the body: the pictures stand beside the four, and below the three of a row.
constexpr double kAcross = 10, kUp = 5.8, kAcrossRow = 4.4;
const char *const kEqualCost = "equal_cost", *const kEqualStep = "equal_step", *const kLesson = "lesson";
constexpr double kEqualStepDefault = 0.02, kLessonDefault = 1.0 / 60;  // s

const char* const kAbout =
    "Prints a scene: one body four times, side by side, from the same start, under lie_euler, buss2, a good stepper "
    "and the closed form. All steppers cost the same CPU time by nominal costs of the methods (equal_cost), or all "
    "take the same step (equal_step). The good stepper is the cheapest that keeps to 1e-3 rad for 120 s. For a lesson: "
    "three times, in one row, under lie_euler, buss2 and the closed form, both steppers at the same step.";

struct Options {
  std::string scene_file, body, mode = kEqualCost;
  std::optional<double> step;  ///< [s], of equal_step and lesson
};

/** One of the bodies that are compared. */
struct Entry {
  std::string method;          ///< also its name
  std::optional<double> step;  ///< [s], of a stepper
  double across, up;           ///< its place, for a viewer at +x [radii of the body]
};

/** Returns a copy of the keys of a body without name, method and effects. */
YAML::Node bare(const YAML::Node& body) {
  YAML::Node out = YAML::Clone(body);
  for (const char* key : {"name", "method", "step", "accuracy", "horizon", "effects", "pictures"}) out.remove(key);
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

/** Returns lie_euler, buss2, a good stepper and the closed form, two above two. */
std::vector<Entry> four(const Options& options, const scene::Body& body, double rate, const cost::MethodCosts& costs) {
  const cost::Choice good = goodStepper(scene::motionSetup(body), rate, costs);
  const std::vector<std::string> steppers = {"lie_euler", "buss2", good.method};

  // All steppers may cost as much as the good one, or more if one of them would have too little left for its steps.
  double budget = good.cost;
  for (const std::string& name : steppers) budget = std::max(budget, kLeastForSteps * rate * costs.of(name).per_state);
  const auto stepOf = [&](const std::string& name) {
    const cost::MethodCost& cost = costs.of(name);
    return options.mode == kEqualStep ? options.step.value_or(kEqualStepDefault)
                                      : cost.per_step / (budget - rate * cost.per_state);
  };
  return {{steppers[0], stepOf(steppers[0]), -kAcross, 0.5 * kUp},
          {steppers[1], stepOf(steppers[1]), 0, 0.5 * kUp},
          {steppers[2], stepOf(steppers[2]), -kAcross, -0.5 * kUp},
          {kClosedForm, std::nullopt, 0, -0.5 * kUp}};
}

/** Returns the two algorithms of the lesson and the closed form, in one row. */
std::vector<Entry> row(double step) {
  return {{"lie_euler", step, -kAcrossRow, 0}, {"buss2", step, 0, 0}, {kClosedForm, std::nullopt, kAcrossRow, 0}};
}

double radiusOf(const scene::Body& body) {
  const Assembly shape = body.shape ? *body.shape : shapes::equivalentBox(body.inertia.moments(), body.inertia.axes());
  return shape.boundingRadius();
}

std::string formatted(const char* format, double a, double b) {
  char text[200];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

double costOf(const Entry& entry, double rate, const cost::MethodCosts& costs) {
  return costs.perSimulatedSecond(entry.method, entry.step.value_or(1), rate);
}

/** Returns a scene in which one body stands once for each entry. @param radius of the body [m]. */
std::string sceneOf(const std::vector<Entry>& entries, const std::string& mode, const YAML::Node& body, double radius,
                    double rate, const cost::MethodCosts& costs) {
  const Entry& first = entries.front();
  YAML::Emitter out;
  out.SetDoublePrecision(17);
  out << YAML::Comment(
      mode == kEqualCost
          ? formatted("Made by compare_scene: every stepper costs a nominal %.3g us of CPU per "
                      "simulated second, at %g states a second.",
                      1e6 * costOf(first, rate, costs), rate)
          : formatted("Made by compare_scene: every step is %g s, at %g states a second.", *first.step, rate));
  out << YAML::BeginMap << YAML::Key << "rate" << YAML::Value << rate << YAML::Key << "bodies" << YAML::Value
      << YAML::BeginSeq;
  for (const Entry& entry : entries) {
    YAML::Node one = bare(body);
    one["name"] = entry.method;
    one["method"] = entry.method;
    if (entry.step) one["step"] = *entry.step;
    YAML::Node place;
    place["type"] = "translation";
    place["position"] = std::vector<double>{0, radius * entry.across, radius * entry.up};
    one["effects"].push_back(place);
    out << one;
    out << YAML::Comment(formatted("costs %.3g us per simulated second, %.3g of them for steps",
                                   1e6 * costOf(entry, rate, costs),
                                   entry.step ? 1e6 * costs.of(entry.method).per_step / *entry.step : 0));
  }
  out << YAML::EndSeq << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

void print(const Options& options) {
  node::requireKnownScene(options.scene_file);
  const YAML::Node tree = scene::readDocument(options.scene_file);
  const scene::Scene scene = scene::readTree(tree, options.scene_file);
  const std::size_t index = indexOf(scene, options.body);
  const double rate = scene.rate.value_or(scene::kDefaultRate);
  const cost::MethodCosts& costs = cost::nominalCosts();
  const std::vector<Entry> entries = options.mode == kLesson ? row(options.step.value_or(kLessonDefault))
                                                             : four(options, scene.bodies[index], rate, costs);
  const std::string text =
      sceneOf(entries, options.mode, tree["bodies"][index], radiusOf(scene.bodies[index]), rate, costs);
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
  app.add_option("--mode", options.mode, "What all steppers have in common, or lesson")
      ->check(tools::oneOf({kEqualCost, kEqualStep, kLesson}))
      ->capture_default_str();
  tools::addPositive(app, "--step", options.step, "s",
                     "Every step [s], with equal_step (default: 0.02) and lesson (default: 1/60)");
  if (const auto code = tools::parse(app, argc, argv)) return *code;
  return tools::exitCodeOf<cost::Unreachable>("compare_scene", kNo, tools::kBadUse, [&] { print(options); });
}
