#include "method_reader.h"

#include <algorithm>
#include <cmath>

#include "number.h"
#include "poinsot/core/step_limits.h"
#include "poinsot/core/stepper.h"
#include "words.h"

namespace poinsot::scene {
namespace {

const char* const kAnyStepper = "stepper";  // beside an accuracy: any method but the closed form
constexpr double kLargestAccuracy = 1;      // rad

std::vector<std::string> namesOfMethods() {
  std::vector<std::string> names = {kClosedForm};
  for (const Method& method : methods()) names.push_back(method.name);
  names.push_back(kAnyStepper);
  return names;
}

/** The scene's, the program's, or the longer of both. */
double readHorizon(const Fields& fields, const ReadOptions& options) {
  const auto given = fields.find("horizon");
  if (!given && options.horizon) return *options.horizon;
  const Place place =
      fields.require("horizon", "how long the accuracy must hold, " + allowedNumber(quantity::kDuration));
  return std::max(readNumber(place, quantity::kDuration), options.horizon.value_or(0));
}

/** @param method empty where the scene names none. */
Accuracy readAccuracy(const Place& place, const Fields& fields, const ReadOptions& options, const std::string& method) {
  Accuracy out;
  out.error = readNumber(place, quantity::kAngleError);
  if (!(out.error <= kLargestAccuracy)) {
    place.refuse(shownNumber(out.error) + " is more than a wrong attitude can be told from a right one",
                 "a positive number up to " + shownNumber(kLargestAccuracy) + " (rad)");
  }
  out.horizon = readHorizon(fields, options);
  if (!method.empty() && method != kAnyStepper) {
    out.candidates = {method};
  } else {
    if (method.empty()) out.candidates.push_back(kClosedForm);
    for (const Method& candidate : methods()) out.candidates.push_back(candidate.name);
  }
  out.place = place.message("");
  return out;
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

void readMethod(const Fields& fields, const ReadOptions& options, Body& body, std::vector<std::string>& warnings) {
  const auto method = fields.find("method");
  const auto step = fields.find("step");
  const auto accuracy = fields.find("accuracy");
  if (const auto horizon = fields.find("horizon"); horizon && !accuracy) {
    horizon->refuse("a horizon says how long an accuracy must hold, and the key accuracy is missing",
                    "accuracy beside it, " + allowedNumber(quantity::kAngleError));
  }
  if (method) body.method = readChoice(*method, namesOfMethods(), {});
  if (accuracy) {
    body.accuracy = readAccuracy(*accuracy, fields, options, method ? body.method : std::string());
    if (step) {
      step->refuse("the key accuracy stands beside it, from which the step follows", "accuracy or step, not both");
    }
    return;
  }
  if (body.method == kAnyStepper) {
    method->refuse("stepper leaves it to an accuracy which one, and the key accuracy is missing",
                   "accuracy and horizon beside it, or one of " + methodNames() + " and a step");
  }
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
