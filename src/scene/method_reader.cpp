#include "method_reader.h"

#include <vector>

#include "number.h"
#include "poinsot/core/motion.h"
#include "words.h"

namespace poinsot::scene {
namespace {

std::vector<std::string> namesOfMethods() {
  std::vector<std::string> names;
  for (const Method& method : methods()) names.push_back(method.name);
  return names;
}

/** Every name that some version of the package has; what the table of methods holds already is known before this. */
const std::vector<std::string>& plannedMethods() {
  static const std::vector<std::string> names = {
      "closed_form", "lie_euler",  "buss2",      "buss3", "buss4", "rk4",  "rkmk4", "cf4",   "midpoint",
      "splitting2",  "splitting4", "splitting6", "dmv2",  "dmv4",  "dmv6", "dmv8",  "dmv10", "stepper"};
  return names;
}

}  // namespace

void readMethod(const Fields& fields, Body& body) {
  for (const char* key : {"accuracy", "horizon"}) {
    if (const auto place = fields.find(key)) {
      place->refuse(std::string(key) + " is not in this version", "method and step");
    }
  }
  const auto method = fields.find("method");
  const auto step = fields.find("step");
  body.method = method ? readChoice(*method, namesOfMethods(), plannedMethods()) : kDefaultMethod;
  if (method && !step) {
    method->refuse(body.method + " goes in steps and the key step is missing",
                   "step, " + allowedNumber(quantity::kStep));
  }
  body.step = step ? readNumber(*step, quantity::kStep) : kDefaultStep;
}

}  // namespace poinsot::scene
