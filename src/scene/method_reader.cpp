#include "method_reader.h"

#include <algorithm>
#include <cmath>

#include "number.h"
#include "poinsot/core/method.h"
#include "poinsot/scene/changes.h"
#include "poinsot/scene/message.h"
#include "step_verdict.h"
#include "words.h"

namespace poinsot::scene {
namespace {

const char* const kAnyStepper = "stepper";  // beside an accuracy: any method but the closed form
constexpr double kLargestAccuracy = 1;      // rad

// For a body with effects where the scene names neither method nor accuracy; a scene is watched for about so long.
constexpr double kDefaultAccuracy = 1e-9, kDefaultHorizon = 60;  // rad, s

/** Returns the words that a scene may name as the method of a body, "stepper" among them. */
std::vector<std::string> namesOfMethods(bool with_effects) {
  std::vector<std::string> names;
  if (!with_effects) names.push_back(kClosedForm);
  for (const Method& method : with_effects ? torquedMethods() : freeMethods()) names.push_back(method.name);
  names.push_back(kAnyStepper);
  return names;
}

std::string readMethodName(const Place& place, const Body& body) {
  const bool with_effects = !body.effects.empty();
  const std::vector<std::string> names = namesOfMethods(with_effects);
  const std::string& word = place.scalar();
  if (!contains(names, word) && contains(namesOfMethods(!with_effects), word)) {
    std::string expected = "one of " + joined(names),
                why = "it is for bodies with effects, and nothing acts on this one";
    if (with_effects) why = "it is for free bodies and takes no " + nameOf(body.effects.front());
    if (word == kClosedForm) {
      expected += ", or no method, which leaves the choice";
      why = "it is the motion of a free body, and " + nameOf(body.effects.front()) + " changes that motion";
    }
    place.refuse(expected, place.found(), why);
  }
  const std::string name = readChoice(place, names);
  if (const Method* method = findMethod(name); method && with_effects) {
    const std::string objection = objectionTo(*method, sumOf(body.inertia, body.effects));
    if (!objection.empty()) place.refuse("one of " + joined(methodsFor(body)), place.found(), objection);
  }
  return name;
}

/** Returns the horizon of the scene or of the program [s]; the longer of both where both give one. */
double readHorizon(const Fields& fields, const ReadOptions& options) {
  const auto given = fields.find("horizon");
  if (!given && options.horizon) return *options.horizon;
  const Place place =
      fields.require("horizon", "how long the accuracy must hold, " + expectedNumber(quantity::kDuration));
  return std::max(readNumber(place, quantity::kDuration), options.horizon.value_or(0));
}

/** @param method empty where the scene names none. */
Accuracy readAccuracy(const Place& place, const Fields& fields, const ReadOptions& options, const Body& body,
                      const std::string& method) {
  Accuracy out;
  out.error = readNumber(place, quantity::kAngleError);
  if (!(out.error <= kLargestAccuracy)) {
    place.refuse("a positive number up to " + numberText(kLargestAccuracy, 15) + " (rad)", numberText(out.error, 15),
                 "such an error leaves a wrong attitude indistinguishable from a right one");
  }
  out.horizon = readHorizon(fields, options);
  if (!method.empty() && method != kAnyStepper) {
    out.candidates = {method};
  } else {
    out.candidates = methodsFor(body);
    if (method == kAnyStepper && body.effects.empty()) out.candidates.erase(out.candidates.begin());  // closed_form
  }
  out.place = place.message("");
  return out;
}

/** Refuses a step at which the method does not follow this body, or appends a warning. */
void judge(const Place& place, const Body& body, std::vector<std::string>& warnings) {
  const StepVerdict verdict = verdictOnStep(body);
  if (verdict.grade == StepJudgement::Grade::sound) return;
  if (verdict.grade == StepJudgement::Grade::hopeless) place.refuse(verdict.instead, verdict.problem);
  warnings.push_back(place.message(verdict.problem + "; better: " + verdict.instead));
}

}  // namespace

void readMethod(const Fields& fields, const ReadOptions& options, Body& body, std::vector<std::string>& warnings) {
  const auto method = fields.find("method");
  const auto step = fields.find("step");
  const auto accuracy = fields.find("accuracy");
  if (const auto horizon = fields.find("horizon"); horizon && !accuracy) {
    horizon->refuse("the key accuracy beside it, " + expectedNumber(quantity::kAngleError), "none",
                    "a horizon says how long an accuracy must hold");
  }
  if (method) body.method = readMethodName(*method, body);
  if (accuracy) {
    body.accuracy = readAccuracy(*accuracy, fields, options, body, method ? body.method : std::string());
    if (step) {
      step->refuse("one of the keys accuracy, step", "both", "the step follows from the accuracy");
    }
    return;
  }
  if (body.method == kAnyStepper) {
    method->refuse("the keys accuracy and horizon beside it, or one of " +
                       methodNames(body.effects.empty() ? freeMethods() : torquedMethods()) + " and a step",
                   method->found() + " alone", "the accuracy decides which stepper it is");
  }
  if (!body.effects.empty() && !method) {
    if (step) {
      step->refuse("no step, or one beside a method (" + joined(methodsFor(body)) + ")", "a step without a method");
    }
    Accuracy usual;
    usual.error = kDefaultAccuracy;
    usual.horizon = options.horizon.value_or(kDefaultHorizon);
    usual.candidates = methodsFor(body);
    usual.place = fields.place().message("");
    usual.by_default = true;
    body.accuracy = usual;
    return;
  }
  if (body.effects.empty() && body.method == kClosedForm) {
    if (!step) return;
    step->refuse("no step, or one beside a method that steps (" + methodNames(freeMethods()) + ")",
                 method ? "a step beside closed_form" : "a step without a method, which means closed_form");
  }
  if (!step) {
    method->refuse("the key step beside it, " + expectedNumber(quantity::kStep), "none",
                   body.method + " goes in steps");
  }
  body.step = readNumber(*step, quantity::kStep);
  judge(*step, body, warnings);
}

}  // namespace poinsot::scene
