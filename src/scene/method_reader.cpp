#include "method_reader.h"

#include <cmath>

#include "number.h"
#include "poinsot/core/step_limits.h"
#include "poinsot/core/stepper.h"
#include "words.h"

namespace poinsot::scene {
namespace {

std::vector<std::string> namesOfMethods() {
  std::vector<std::string> names = {kClosedForm};
  for (const Method& method : methods()) names.push_back(method.name);
  return names;
}

/** Every name that some version of the package has; what this version has is known before this. */
const std::vector<std::string>& plannedMethods() {
  static const std::vector<std::string> names = {
      "lie_euler",  "buss2",      "buss3", "buss4", "rk4",  "rkmk4", "cf4",   "midpoint", "splitting2",
      "splitting4", "splitting6", "dmv2",  "dmv4",  "dmv6", "dmv8",  "dmv10", "stepper"};
  return names;
}

/** To two digits, never upwards. */
double roundedDown(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  return unit > 0 ? std::floor(x / unit) * unit : x;
}

/** Refuses a step at which the method does not follow this body, or appends a warning. */
void judge(const Place& place, const Body& body, std::vector<std::string>& warnings) {
  const Eigen::Vector3d omega = body.inertia.axes().conjugate() * body.omega_body;
  const StepJudgement judgement = judgeStep(*findMethod(body.method), body.inertia.moments(), omega, *body.step);
  if (judgement.grade == StepJudgement::Grade::sound) return;
  const std::string problem = body.method + " with a step of " + shownNumber(*body.step) +
                              " s at |Omega| = " + shownNumber(omega.stableNorm()) + " rad/s: " + judgement.reason;
  const bool some_step_will_do = judgement.largest_sound > 0;
  const std::string instead =
      (some_step_will_do ? "a step of at most " + shownNumber(roundedDown(judgement.largest_sound)) + " s, or "
                         : std::string()) +
      kClosedForm + ", which has no step";
  if (judgement.grade == StepJudgement::Grade::hopeless) place.refuse(problem, instead);
  warnings.push_back(place.message(problem + "; better: " + instead));
}

}  // namespace

void readMethod(const Fields& fields, Body& body, std::vector<std::string>& warnings) {
  for (const char* key : {"accuracy", "horizon"}) {
    if (const auto place = fields.find(key)) {
      place->refuse(std::string(key) + " is not in this version", "method and step");
    }
  }
  const auto method = fields.find("method");
  const auto step = fields.find("step");
  if (method) body.method = readChoice(*method, namesOfMethods(), plannedMethods());
  if (body.method == kClosedForm) {
    if (!step) return;
    step->refuse(
        method ? "closed_form takes no step" : "no method is named, and the default, closed_form, takes no step",
        "no step, or one beside a method that steps: " + methodNames());
  }
  if (!step) {
    method->refuse(body.method + " goes in steps and the key step is missing",
                   "step, " + allowedNumber(quantity::kStep));
  }
  body.step = readNumber(*step, quantity::kStep);
  judge(*step, body, warnings);
}

}  // namespace poinsot::scene
