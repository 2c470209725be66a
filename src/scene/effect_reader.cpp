#include "effect_reader.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>
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

Axes readFrame(const Fields& fields) {
  const Place place = fields.require("frame", "body or world: in which axes the torque is constant");
  return readChoice(place, {"body", "world"}) == "body" ? Axes::body : Axes::world;
}

Eigen::Vector3d requireVector(const Fields& fields, const char* key, const Quantity& quantity) {
  return readVector(fields.require(key, allowedNumbers(3, quantity)), quantity);
}

double requireNumber(const Fields& fields, const char* key, const Quantity& quantity) {
  return readNumber(fields.require(key, allowedNumber(quantity)), quantity);
}

/** Whether the body has an effect of this type already. */
template <class Type>
bool has(const Body& body) {
  return std::any_of(body.effects.begin(), body.effects.end(),
                     [](const Effect& effect) { return std::holds_alternative<Type>(effect); });
}

template <class Type>
void requireFirst(const Fields& fields, const Body& body) {
  if (!has<Type>(body)) return;
  fields.place().refuse("a second " + std::string(Type::kName), "one " + std::string(Type::kName) + " a body");
}

void readConstantTorque(const Fields& fields, Body& body) {
  const Axes axes = readFrame(fields);
  body.effects.push_back(ConstantTorque{axes, requireVector(fields, "torque", quantity::kTorque)});
}

void readGravityTorque(const Fields& fields, Body& body) {
  GravityTorque out;
  out.mass = requireNumber(fields, "mass", quantity::kMass);
  if (const auto place = fields.find("gravity")) out.gravity = readVector(*place, quantity::kAcceleration);
  out.centre_of_mass = requireVector(fields, "centre_of_mass", quantity::kPosition);
  body.effects.push_back(out);
}

void readGravityGradient(const Fields& fields, Body& body) {
  requireFirst<GravityGradient>(fields, body);
  GravityGradient out;
  out.orbit_rate = requireNumber(fields, "orbit_rate", quantity::kOrbitRate);
  const auto direction = [&fields](const char* key) {
    const Place place = fields.require(key, "a direction in world axes, a list of 3 finite numbers, not all zero");
    const Eigen::Vector3d v = readVector(place, quantity::kDirection);
    if (v.isZero(0)) place.refuse("a zero vector is no direction", "3 finite numbers, not all zero");
    if (!std::isfinite(v.stableNorm()))
      place.refuse("its length is not finite in double precision", "a shorter vector");
    return v;
  };
  out.orbit_normal = direction("orbit_normal");
  out.radial_at_start = direction("radial_at_start");
  try {
    Torques alone(body.inertia);
    out.addTo(alone);
  } catch (const std::invalid_argument& objection) {
    fields.find("radial_at_start")->refuse(objection.what(), "a direction in the plane of the orbit");
  }
  body.effects.push_back(out);
}

void readViscousDamping(const Fields& fields, Body& body) {
  const std::string allowed = allowedNumber(quantity::kDamping) + ", or a list of 3, one for each body axis";
  const Place place = fields.require("coefficient", allowed);
  ViscousDamping out;
  if (place.node().IsSequence()) {
    out.coefficients = readVector(place, quantity::kDamping);
  } else {
    out.coefficients.setConstant(readNumber(place, quantity::kDamping));
  }
  body.effects.push_back(out);
}

void readInternalDissipation(const Fields& fields, Body& body) {
  requireFirst<InternalDissipation>(fields, body);
  InternalDissipation out;
  out.slug_inertia = requireNumber(fields, "slug_inertia", quantity::kInertia);
  out.damping = requireNumber(fields, "damping", quantity::kDamping);
  body.effects.push_back(out);
}

void readTorqueSchedule(const Fields& fields, Body& body) {
  const char* const allowed = "a list of segments such as {from: 1, to: 2, frame: body, torque: [0, 0, 1]}";
  const Place list = fields.require("segments", allowed);
  list.requireList(allowed);
  if (list.node().size() == 0) list.refuse("an empty list switches nothing", allowed);
  TorqueSchedule out;
  for (std::size_t i = 0; i < list.node().size(); ++i) {
    const Fields segment(list.item(i), allowed);
    segment.allowOnly({"from", "to", "frame", "torque"});
    TorqueSchedule::Segment read;
    read.from = requireNumber(segment, "from", quantity::kTime);
    read.to = requireNumber(segment, "to", quantity::kTime);
    read.axes = readFrame(segment);
    read.torque = requireVector(segment, "torque", quantity::kTorque);
    if (!(read.from < read.to)) {
      segment.find("to")->refuse(numberText(read.to, 15) + " s is not after from, " + numberText(read.from, 15) + " s",
                                 "a time after from");
    }
    for (const TorqueSchedule::Segment& other : out.segments) {
      if (read.from >= other.to || read.to <= other.from) continue;
      segment.find("from")->refuse(
          "from " + numberText(read.from, 15) + " to " + numberText(read.to, 15) +
              " s overlaps another segment, from " + numberText(other.from, 15) + " to " + numberText(other.to, 15) +
              " s",
          "segments that do not overlap; a second torque_schedule for torques at the same time");
    }
    out.segments.push_back(read);
  }
  body.effects.push_back(out);
}

/** A new effect is one line here. */
const std::vector<EffectType>& effectTypes() {
  static const std::vector<EffectType> table = {
      {"translation", {"position", "velocity", "acceleration"}, readTranslation},
      {ConstantTorque::kName, {"frame", "torque"}, readConstantTorque},
      {GravityTorque::kName, {"mass", "gravity", "centre_of_mass"}, readGravityTorque},
      {GravityGradient::kName, {"orbit_rate", "orbit_normal", "radial_at_start"}, readGravityGradient},
      {ViscousDamping::kName, {"coefficient"}, readViscousDamping},
      {InternalDissipation::kName, {"slug_inertia", "damping"}, readInternalDissipation},
      {TorqueSchedule::kName, {"segments"}, readTorqueSchedule},
  };
  return table;
}

void readEffect(const Place& place, Body& body) {
  std::vector<std::string> names;
  for (const EffectType& type : effectTypes()) names.push_back(type.name);

  const Fields fields(place, "an effect, such as {type: translation, velocity: [0, 0, 1]}");
  const std::string name = readChoice(fields.require("type", "one of " + joined(names)), names);
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
  for (std::size_t i = 0; i < place.node().size(); ++i) {
    readEffect(place.item(i), body);
    try {
      sumOf(body.inertia, body.effects);
    } catch (const std::invalid_argument& objection) {
      place.item(i).refuse(objection.what(), "effects that go together and whose sum doubles hold");
    }
    if (body.translation && has<GravityTorque>(body)) {
      place.item(i).refuse("gravity_torque holds the body at a fixed pivot, and translation moves it",
                           "one of gravity_torque, translation");
    }
  }
}

}  // namespace poinsot::scene
