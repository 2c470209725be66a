#include "step_verdict.h"

#include <cmath>

#include "number.h"
#include "poinsot/core/method.h"
#include "poinsot/core/step_limits.h"

namespace poinsot::scene {
namespace {

/** Returns x > 0 rounded to two digits, never upwards. */
double roundedDown(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  return unit > 0 ? std::floor(x / unit) * unit : x;
}

StepJudgement judgement(const Body& body) {
  const Eigen::Vector3d omega = body.inertia.toPrincipal(body.omega_body);
  const Method& method = *findMethod(body.method);
  if (body.effects.empty()) return judgeStep(method, body.inertia.moments(), omega, *body.step);
  return judgeStep(method, sumOf(body.inertia, body.effects), body.attitude * body.inertia.axes(), omega, *body.step);
}

}  // namespace

StepVerdict verdictOnStep(const Body& body) {
  const StepJudgement judged = judgement(body);
  StepVerdict out;
  out.grade = judged.grade;
  if (judged.grade == StepJudgement::Grade::sound) return out;
  out.problem = body.method + " with a step of " + numberText(*body.step, 15) +
                " s at |Omega| = " + numberText(body.omega_body.stableNorm(), 4) + " rad/s: " + judged.reason;
  if (judged.largest_sound > 0) {
    out.largest_sound = roundedDown(judged.largest_sound);
    out.instead = "a step of at most " + numberText(out.largest_sound, 15) + " s, or ";
  }
  out.instead += body.effects.empty() ? std::string(kClosedForm) + ", which has no step"
                                      : "no method and no step, which leaves the choice";
  return out;
}

}  // namespace poinsot::scene
