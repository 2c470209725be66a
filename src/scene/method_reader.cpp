#include "method_reader.h"

#include <algorithm>
#include <cmath>

#include "number.h"
#include "poinsot/core/method.h"
#include "poinsot/scene/changes.h"
#include "step_verdict.h"
#include "words.h"

namespace poinsot::scene {
namespace {

const char* const kAnyStepper = "stepper";  // beside an accuracy: any method but the closed form
constexpr double kLargestAccuracy = 1;      // rad

// Where a scene names neither method nor accuracy for a body with effects. The time is about that of a look at a scene.
constexpr double kDefaultAccuracy = 1e-9, kDefaultHorizon = 60;  // rad, s

/** What a scene may name as the method of a body; "stepper" among them. */
std::vector<std::string> namesOfMethods(bool with_effects) {
  std::vector<std::string> names;
  if (!with_effects) names.push_back(kClosedForm);
  for (const Method& method : with_effects ? torquedMethods() : freeMethods()) names.push_back(method.name);
  names.push_back(kAnyStepper);
  return names;
}

std::string readMethodName(const Place& place, const Body& body) {
  const bool with_effects = !body.effects.empty();
  const std::vector<std::string> names = namesOfMethods(with_effects), others = namesOfMethods(!with_effects);
  const std::string word = place.node().IsScalar() ? place.node().Scalar() : "";
  const bool belongs_to_others = std::find(names.begin(), names.end(), word) == names.end() &&
                                 std::find(others.begin(), others.end(), word) != others.end();
  if (!with_effects) {
    if (belongs_to_others) {
      place.refuse(word + " is a method for bodies with effects, and nothing acts on this one", joined(names));
    }
    return readChoice(place, names);
  }
  const std::string effect = nameOf(body.effects.front());
  if (word == kClosedForm) {
    place.refuse("closed_form is the motion of a free body, and " + effect + " makes it another, which has none",
                 joined(names) + ", or no method, which leaves the choice");
  }
  if (belongs_to_others) {
    place.refuse(word + " is a method for free bodies and takes no " + effect, joined(names));
  }
  const std::string name = readChoice(place, names);
  if (const Method* method = findMethod(name)) {
    const std::string objection = objectionTo(*method, sumOf(body.inertia, body.effects));
    if (!objection.empty()) place.refuse(objection, joined(methodsFor(body)));
  }
  return name;
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
Accuracy readAccuracy(const Place& place, const Fields& fields, const ReadOptions& options, const Body& body,
                      const std::string& method) {
  Accuracy out;
  out.error = readNumber(place, quantity::kAngleError);
  if (!(out.error <= kLargestAccuracy)) {
    place.refuse(numberText(out.error, 15) + " is more than a wrong attitude can be told from a right one",
                 "a positive number up to " + numberText(kLargestAccuracy, 15) + " (rad)");
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
  if (verdict.grade == StepJudgement::Grade::hopeless) place.refuse(verdict.problem, verdict.instead);
  warnings.push_back(place.message(verdict.problem + "; better: " + verdict.instead));
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
  if (method) body.method = readMethodName(*method, body);
  if (accuracy) {
    body.accuracy = readAccuracy(*accuracy, fields, options, body, method ? body.method : std::string());
    if (step) {
      step->refuse("the key accuracy stands beside it, from which the step follows", "accuracy or step, not both");
    }
    return;
  }
  if (body.method == kAnyStepper) {
    method->refuse("stepper leaves it to an accuracy which one, and the key accuracy is missing",
                   "accuracy and horizon beside it, or one of " +
                       methodNames(body.effects.empty() ? freeMethods() : torquedMethods()) + " and a step");
  }
  if (!body.effects.empty() && !method) {
    if (step) {
      step->refuse("no method is named that would take it",
                   "no step, or one beside a method: " + joined(methodsFor(body)));
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
    step->refuse(
        method ? "closed_form takes no step" : "no method is named, and the default, closed_form, takes no step",
        "no step, or one beside a method that steps: " + methodNames(freeMethods()));
  }
  if (!step) {
    method->refuse(body.method + " goes in steps and the key step is missing",
                   "step, " + allowedNumber(quantity::kStep));
  }
  body.step = readNumber(*step, quantity::kStep);
  judge(*step, body, warnings);
}

}  // namespace poinsot::scene
