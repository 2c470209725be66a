#include "poinsot/cost/resolve_accuracy.h"

#include <cmath>

#include "poinsot/core/number_text.h"
#include "poinsot/cost/choice.h"
#include "poinsot/cost/method_costs.h"
#include "poinsot/scene/message.h"
#include "poinsot/scene/motion_setup.h"
#include "poinsot/scene/reader.h"

namespace poinsot::cost {
namespace {

std::string sentence(const scene::Body& body, const Choice& choice) {
  const scene::Accuracy& accuracy = *body.accuracy;
  std::string out = body.name + ": " + choice.method;
  if (choice.step) out += " with a step of " + numberText(*choice.step, 6) + " s";
  out += " for an accuracy of " + numberText(accuracy.error, 3) + " rad over " + numberText(accuracy.horizon, 3) +
         " s; estimated error " + numberText(choice.estimated_error, 3) + " rad, ";
  if (!body.effects.empty()) {
    out += "verified by step refinement " + numberText(choice.verified_error, 3) + " rad";
    if (!std::isfinite(choice.verified_error)) {
      return out.substr(0, out.rfind("; ")) +
             "; not verified: that takes too many steps, or the motion is lost; cost " + numberText(choice.cost, 3) +
             " CPU s per simulated s";
    }
    if (choice.verified_error > accuracy.error) out += ", the best that doubles allow for a very sensitive motion";
  } else {
    out += choice.step ? "verified by the closed form " + numberText(choice.verified_error, 3) + " rad"
                       : "held to by references of 60 digits";
  }
  return out + "; cost " + numberText(choice.cost, 3) + " CPU s per simulated s";
}

/** Returns the choice for the accuracy, or the most exact one where that accuracy is out of reach. */
Choice asWellAsCanBe(const MotionSetup& setup, const AccuracyRequest& request, const MethodCosts& costs,
                     const std::atomic<bool>& cancel) {
  try {
    return choose(setup, request, costs, cancel);
  } catch (const Unreachable&) {
    return mostExact(setup, request, costs, cancel);
  }
}

}  // namespace

std::vector<std::string> resolveAccuracies(scene::Scene& scene, double rate, const std::atomic<bool>& cancel) {
  const MethodCosts& costs = nominalCosts();
  std::vector<std::string> out;
  for (scene::Body& body : scene.bodies) {
    if (!body.accuracy) continue;
    const scene::Accuracy& accuracy = *body.accuracy;
    const MotionSetup setup = scene::motionSetup(body);
    const AccuracyRequest asked{accuracy.error, accuracy.horizon, rate, accuracy.candidates};
    try {
      const Choice choice =
          accuracy.by_default ? asWellAsCanBe(setup, asked, costs, cancel) : choose(setup, asked, costs, cancel);
      body.method = choice.method;
      body.step = choice.step;
      out.push_back(sentence(body, choice));
    } catch (const Unreachable& error) {
      const std::string closed_form =
          body.effects.empty() ? ", or no method (closed_form reaches " + numberText(kClosedFormError, 3) + " rad)"
                               : "";
      throw scene::Error(
          accuracy.place +
          scene::expectedGot("a larger accuracy" + std::string(closed_form.empty() ? " or " : ", ") +
                                 "a shorter horizon" + closed_form,
                             numberText(accuracy.error, 3) + " rad for " + numberText(accuracy.horizon, 3) + " s",
                             error.what()));
    }
  }
  return out;
}

}  // namespace poinsot::cost
