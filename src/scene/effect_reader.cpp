#include "effect_reader.h"

#include <stdexcept>
#include <vector>

#include "fields.h"
#include "number.h"
#include "words.h"

namespace poinsot::scene {
namespace {

/** A type of effect: its keys besides `type`, and what puts it into the body. */
struct EffectType {
  const char* name;
  std::vector<std::string> keys;
  void (*read)(const Fields& fields, Body& body);
};

void readTranslation(const Fields& fields, Body& body) {
  if (body.translation) fields.place().refuse("a second translation", "one translation a body");
  Translation translation;
  if (const auto place = fields.find("position")) translation.position = readVector(*place, quantity::kPosition);
  if (const auto place = fields.find("velocity")) translation.velocity = readVector(*place, quantity::kVelocity);
  if (const auto place = fields.find("acceleration")) {
    translation.acceleration = readVector(*place, quantity::kAcceleration);
  }
  body.translation = translation;
}

/** A new effect is one line here, and no longer one of the planned. */
const std::vector<EffectType>& effectTypes() {
  static const std::vector<EffectType> table = {
      {"translation", {"position", "velocity", "acceleration"}, readTranslation},
  };
  return table;
}

const std::vector<std::string>& plannedTypes() {
  static const std::vector<std::string> names = {"constant_torque", "gravity_torque",       "gravity_gradient",
                                                 "viscous_damping", "internal_dissipation", "torque_schedule"};
  return names;
}

void readEffect(const Place& place, Body& body) {
  std::vector<std::string> names;
  for (const EffectType& type : effectTypes()) names.push_back(type.name);

  const Fields fields(place, "an effect, such as {type: translation, velocity: [0, 0, 1]}");
  const std::string name = readChoice(fields.require("type", "one of " + joined(names)), names, plannedTypes());
  for (const EffectType& type : effectTypes()) {
    if (name != type.name) continue;
    std::vector<std::string> keys = {"type"};
    keys.insert(keys.end(), type.keys.begin(), type.keys.end());
    fields.allowOnly(keys);
    return type.read(fields, body);
  }
  throw std::logic_error("a type of effect that is chosen but not in the table");
}

}  // namespace

void readEffects(const Place& place, Body& body) {
  place.requireList("a list of effects");
  for (std::size_t i = 0; i < place.node().size(); ++i) readEffect(place.item(i), body);
}

}  // namespace poinsot::scene
