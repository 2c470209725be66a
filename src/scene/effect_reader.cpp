#include "effect_reader.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>
#include <vector>

#include "fields.h"
#include "number.h"

namespace poinsot::scene {
namespace {

/** A type of effect: its keys besides `type`, and the function that reads it into the body. */
struct EffectType {
  std::string name;
  std::vector<std::string> keys;
  void (*read)(const Fields& fields, Body& body);
};

/** Refuses the effect if the body has one of its type already. */
void requireFirst(const Fields& fields, const std::string& type, bool is_second) {
  if (is_second) fields.place().refuse("one " + type + " per body", "a second");
}

void readTranslation(const Fields& fields, Body& body) {
  requireFirst(fields, Translation::kName, body.translation.has_value());
  Translation translation;
  if (const auto place = fields.find("position")) translation.position = readVector(*place, quantity::kPosition);
  if (const auto place = fields.find("velocity")) translation.velocity = readVector(*place, quantity::kVelocity);
  if (const auto place = fields.find("acceleration")) {
    translation.acceleration = readVector(*place, quantity::kAcceleration);
  }
  body.translation = translation;
}

Axes readFrame(const Fields& fields) {
  return fields.requireChoice("frame", {"body", "world"}) == "body" ? Axes::body : Axes::world;
}

/** Whether the body has an effect of this type already. */
template <class Type>
bool has(const Body& body) {
  return std::any_of(body.effects.begin(), body.effects.end(),
                     [](const Effect& effect) { return std::holds_alternative<Type>(effect); });
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
  requireFirst(fields, GravityGradient::kName, has<GravityGradient>(body));
  GravityGradient out;
  out.orbit_rate = requireNumber(fields, "orbit_rate", quantity::kOrbitRate);
  const auto direction = [&fields](const char* key) {
    const Place place = fields.require(key, "a direction in world axes, a list of 3 finite numbers, not all zero");
    const Eigen::Vector3d v = readVector(place, quantity::kDirection);
    if (v.isZero(0)) place.refuse("3 finite numbers, not all zero", "a zero vector");
    if (!std::isfinite(v.stableNorm())) {
      place.refuse("a vector whose length is finite in double precision", "[" + listed(v) + "]");
    }
    return v;
  };
  out.orbit_normal = direction("orbit_normal");
  out.radial_at_start = direction("radial_at_start");
  try {
    Torques alone(body.inertia);
    out.addTo(alone);
  } catch (const std::invalid_argument& objection) {
    fields.find("radial_at_start")
        ->refuse("a direction in the plane of the orbit", "[" + listed(out.radial_at_start) + "]", objection.what());
  }
  body.effects.push_back(out);
}

void readViscousDamping(const Fields& fields, Body& body) {
  const Place place =
      fields.require("coefficient", expectedNumber(quantity::kDamping) + ", or a list of 3, one for each body axis");
  ViscousDamping out;
  if (place.node().IsSequence()) {
    out.coefficients = readVector(place, quantity::kDamping);
  } else {
    out.coefficients.setConstant(readNumber(place, quantity::kDamping));
  }
  body.effects.push_back(out);
}

void readInternalDissipation(const Fields& fields, Body& body) {
  requireFirst(fields, InternalDissipation::kName, has<InternalDissipation>(body));
  InternalDissipation out;
  out.slug_inertia = requireNumber(fields, "slug_inertia", quantity::kInertia);
  out.damping = requireNumber(fields, "damping", quantity::kDamping);
  body.effects.push_back(out);
}

void readTorqueSchedule(const Fields& fields, Body& body) {
  const char* const expected =
      "a list of at least one segment, such as {from: 1, to: 2, frame: body, torque: [0, 0, 1]}";
  const Place list = fields.require("segments", expected);
  list.requireList(expected, 1);
  TorqueSchedule out;
  for (std::size_t i = 0; i < list.node().size(); ++i) {
    const Fields segment(list.item(i), "a segment, such as {from: 1, to: 2, frame: body, torque: [0, 0, 1]}");
    segment.allowOnly({"from", "to", "frame", "torque"});
    TorqueSchedule::Segment read;
    read.from = requireNumber(segment, "from", quantity::kTime);
    read.to = requireNumber(segment, "to", quantity::kTime);
    read.axes = readFrame(segment);
    read.torque = requireVector(segment, "torque", quantity::kTorque);
    if (!(read.from < read.to)) {
      segment.find("to")->refuse("a time after from, " + numberText(read.from, 15) + " s",
                                 numberText(read.to, 15) + " s");
    }
    for (const TorqueSchedule::Segment& other : out.segments) {
      if (read.from >= other.to || read.to <= other.from) continue;
      const auto span = [](const TorqueSchedule::Segment& s) {
        return "from " + numberText(s.from, 15) + " to " + numberText(s.to, 15) + " s";
      };
      segment.find("from")->refuse(
          "segments that do not overlap (torques at the same time go into a second torque_schedule)",
          "one " + span(read) + " that overlaps another, " + span(other));
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
  const Fields fields(place, "an effect, such as {type: translation, velocity: [0, 0, 1]}");
  fields.requireType(effectTypes()).read(fields, body);
}

}  // namespace

void readEffects(const Place& place, Body& body) {
  place.requireList("a list of effects");
  for (std::size_t i = 0; i < place.node().size(); ++i) {
    readEffect(place.item(i), body);
    try {
      sumOf(body.inertia, body.effects);
    } catch (const std::invalid_argument& objection) {
      place.item(i).refuse("an effect that can act beside those before it", "one that cannot", objection.what());
    }
    if (body.translation && has<GravityTorque>(body)) {
      place.item(i).refuse("one of gravity_torque, translation", "both",
                           "gravity_torque holds the body at a fixed pivot, and translation moves it");
    }
  }
}

}  // namespace poinsot::scene
