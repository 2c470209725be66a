#include "poinsot/scene/changes.h"

#include <cmath>

#include "number.h"
#include "poinsot/core/method.h"
#include "poinsot/core/step_limits.h"
#include "poinsot/scene/message.h"
#include "poinsot/scene/reader.h"
#include "step_verdict.h"
#include "words.h"

namespace poinsot::scene {
namespace {

constexpr double kTurnPerStep = 0.02;  // rad
constexpr double kStepAtRest = 0.01;   // s

[[noreturn]] void refuse(const Body& body, const std::string& expected, const std::string& got,
                         const std::string& why = "") {
  throw Error("body \"" + body.name + "\": " + expectedGot(expected, got, why));
}

bool hasStep(const Body& body) {
  return body.method != kClosedForm && body.step.has_value();
}

/** Returns the greatest of 1, 2 and 5 times a power of ten that is at most x. */
double roundStep(double x) {
  const double decade = std::pow(10, std::floor(std::log10(x)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * decade <= x) return digit * decade;
  }
  return decade;
}

double suitableStep(Body body) {
  const Eigen::Vector3d omega = body.inertia.toPrincipal(body.omega_body);
  const double fastest = orbitRates(body.inertia.moments(), omega).fastest();
  body.step = fastest > 0 ? roundStep(kTurnPerStep / fastest) : kStepAtRest;
  const StepVerdict verdict = verdictOnStep(body);
  return verdict.largest_sound > 0 ? verdict.largest_sound : *body.step;
}

}  // namespace

std::vector<std::string> methodsFor(const Body& body) {
  std::vector<std::string> out;
  if (body.effects.empty()) {
    out.push_back(kClosedForm);
    for (const Method& method : freeMethods()) out.push_back(method.name);
    return out;
  }
  const Torques torques = sumOf(body.inertia, body.effects);
  for (const Method& method : torquedMethods()) {
    if (objectionTo(method, torques).empty()) out.push_back(method.name);
  }
  return out;
}

Body withMethod(Body body, const std::string& method, std::optional<double> step, std::vector<std::string>& warnings) {
  const std::vector<std::string> known = methodsFor(body);
  if (!contains(known, method)) {
    refuse(body, "one of the methods that move this body, " + joined(known),
           "\"" + method + "\"" + didYouMean(method, known));
  }
  body.method = method;
  body.accuracy.reset();
  body.step.reset();
  if (method == kClosedForm) return body;
  if (step && !(*step > 0 && std::isfinite(*step))) {
    refuse(body, expectedNumber(quantity::kStep) + " as step", numberText(*step, 15));
  }
  body.step = step ? *step : suitableStep(body);
  const StepVerdict verdict = verdictOnStep(body);
  if (verdict.grade == StepJudgement::Grade::hopeless) refuse(body, verdict.instead, verdict.problem);
  if (verdict.grade == StepJudgement::Grade::doubtful) {
    warnings.push_back("body \"" + body.name + "\": " + verdict.problem + "; better: " + verdict.instead);
  }
  return body;
}

Body withSpin(Body body, const MotionState& now, const Eigen::Vector3d& omega_body) {
  const std::string problem = outOfRange(body.inertia, omega_body);
  if (!problem.empty()) refuse(body, kExpectedSpin, "[" + listed(omega_body) + "]", problem);
  body.attitude = now.attitude;
  body.omega_body = omega_body;
  if (body.translation) {
    body.translation->position = now.position;
    body.translation->velocity = now.velocity;
  }
  if (hasStep(body) && !body.accuracy) {
    const StepVerdict verdict = verdictOnStep(body);
    if (verdict.grade == StepJudgement::Grade::hopeless) refuse(body, verdict.instead, verdict.problem);
  }
  return body;
}

Body withStartOf(Body body, const Body& other) {
  body.attitude = other.attitude;
  body.omega_body = other.omega_body;
  body.translation = other.translation;
  if (hasStep(body) && !body.accuracy && verdictOnStep(body).grade == StepJudgement::Grade::hopeless) return other;
  return body;
}

}  // namespace poinsot::scene
