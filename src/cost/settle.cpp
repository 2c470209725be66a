#include "poinsot/cost/settle.h"

#include <algorithm>
#include <cstdio>

#include "poinsot/cost/choice.h"
#include "poinsot/scene/motion_setup.h"
#include "poinsot/scene/reader.h"

namespace poinsot::cost {
namespace {

std::string shown(double value, const char* format = "%.3g") {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string sentence(const scene::Body& body, const Choice& choice) {
  const scene::Accuracy& wish = *body.accuracy;
  std::string out = body.name + ": " + choice.method;
  if (choice.step) out += " with a step of " + shown(*choice.step, "%.6g") + " s";
  out += " for an accuracy of " + shown(wish.error) + " rad over " + shown(wish.horizon) + " s; estimated error " +
         shown(choice.estimated_error) + " rad, ";
  out += choice.step ? "verified by the closed form " + shown(choice.verified_error) + " rad"
                     : "held to by references of 60 digits";
  return out + "; cost " + shown(choice.cost) + " CPU s per simulated s";
}

}  // namespace

std::vector<std::string> settleMethods(scene::Scene& scene, double rate) {
  const auto wishes = [](const scene::Body& body) { return body.accuracy.has_value(); };
  if (std::none_of(scene.bodies.begin(), scene.bodies.end(), wishes)) return {};
  return settleMethods(scene, rate, costsOfThisMachine());
}

std::vector<std::string> settleMethods(scene::Scene& scene, double rate, const MethodCosts& costs) {
  std::vector<std::string> out;
  for (scene::Body& body : scene.bodies) {
    if (!body.accuracy) continue;
    const scene::Accuracy& wish = *body.accuracy;
    try {
      const Choice choice = choose(scene::motionSetup(body), {wish.error, wish.horizon, rate, wish.candidates}, costs);
      body.method = choice.method;
      body.step = choice.step;
      out.push_back(sentence(body, choice));
    } catch (const Unreachable& error) {
      throw scene::Error(
          wish.place + error.what() +
          "; allowed: a larger accuracy, a shorter horizon, or no method, which is closed_form and reaches " +
          shown(kClosedFormError));
    }
  }
  return out;
}

}  // namespace poinsot::cost
