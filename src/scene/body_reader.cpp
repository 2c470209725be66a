#include "body_reader.h"

#include <cmath>
#include <stdexcept>
#include <variant>

#include "appearance_reader.h"
#include "effect_reader.h"
#include "fields.h"
#include "inertia_reader.h"
#include "look_reader.h"
#include "method_reader.h"
#include "number.h"
#include "poinsot/core/motion.h"
#include "shape_reader.h"
#include "words.h"

namespace poinsot::scene {
namespace {

constexpr double kSameMass = 1e-6;  // relative

const char* const kExpectedBody = "a body, such as {name: brick, inertia: [1, 2, 3], angular_velocity: [0, 1, 0]}";

/** Returns the place with the body's name, if that is a scalar, for all messages that follow. */
Place withName(const Place& place) {
  if (!place.node().IsMap()) return place;
  const YAML::Node name = place.node()["name"];
  return name.IsDefined() && name.IsScalar() ? place.called(name.Scalar()) : place;
}

void readInertiaOrShape(const Fields& fields, Body& body, std::vector<std::string>& warnings) {
  const auto inertia = fields.find("inertia");
  const auto shape = fields.find("shape");
  if (inertia.has_value() == shape.has_value()) {
    fields.place().refuse("exactly one of the keys inertia, shape", inertia ? "both" : "none");
  }
  if (inertia) {
    body.inertia = readInertia(*inertia);
  } else {
    body.shape = readShape(*shape);
    try {
      body.inertia = PrincipalInertia::fromTensor(body.shape->inertiaTensor());
    } catch (const std::invalid_argument& objection) {
      shape->refuse(kExpectedSizes, "others", objection.what());
    }
  }
  if (!body.inertia.satisfiesTriangleInequality()) {
    warnings.push_back((inertia ? inertia : shape)
                           ->message("the principal moments " + listed(body.inertia.moments()) +
                                     " kg·m² are those of no real body (one exceeds the sum of the other two); it is "
                                     "simulated nevertheless"));
  }
}

/**
 * Refers a shape's moments to the pivot on which the body hangs, by Steiner's theorem; a shape gives them about its
 * centre of mass. Body axes keep their directions.
 */
void movePivot(const Fields& fields, Body& body) {
  if (!body.shape) return;
  const auto refuse = [&](const char* expected, const std::string& got, const std::string& why = "") {
    fields.find("effects")->refuse(expected, got, why);
  };
  bool moved = false;
  for (const Effect& effect : body.effects) {
    const auto* weight = std::get_if<GravityTorque>(&effect);
    if (!weight) continue;
    if (moved) refuse("one gravity_torque, or inertia instead of shape", "a second gravity_torque");
    moved = true;
    const double mass = body.shape->mass();
    if (!(std::abs(weight->mass - mass) <= kSameMass * mass)) {
      refuse("the same mass in gravity_torque and shape",
             numberText(weight->mass, 15) + " kg and " + numberText(mass, 15) + " kg");
    }
    const Eigen::Vector3d& c = weight->centre_of_mass;
    body.shape_position = c;
    try {
      body.inertia = PrincipalInertia::fromTensor(
          body.shape->inertiaTensor() + mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose()));
    } catch (const std::invalid_argument& objection) {
      refuse("a centre_of_mass so near the pivot of gravity_torque that doubles hold the moments about it",
             "[" + listed(c) + "] m", objection.what());
    }
  }
}

void readAngularVelocity(const Fields& fields, Body& body) {
  body.omega_body = requireVector(fields, "angular_velocity", quantity::kAngularVelocity);
  const std::string problem = outOfRange(body.inertia, body.omega_body);
  if (problem.empty()) return;
  fields.find("angular_velocity")
      ->refuse(kExpectedSpin, "[" + listed(body.omega_body) + "]", "with this inertia " + problem);
}

}  // namespace

Body readBody(const Place& unnamed, const ReadOptions& options, std::vector<std::string>& warnings) {
  const Fields fields(withName(unnamed), kExpectedBody);
  fields.allowOnly({"name", "inertia", "shape", "appearance", "attitude", "angular_velocity", "method", "step",
                    "accuracy", "horizon", "effects", "pictures", "stand", "colour"});

  Body body;
  body.name = readName(fields.require("name", kExpectedName));
  readInertiaOrShape(fields, body, warnings);
  if (const auto appearance = fields.find("appearance")) body.appearance = readAppearance(*appearance);
  if (const auto effects = fields.find("effects")) readEffects(*effects, body);
  movePivot(fields, body);
  if (const auto attitude = fields.find("attitude")) body.attitude = readRotation(*attitude);
  readAngularVelocity(fields, body);
  readLook(fields, body);
  readMethod(fields, options, body, warnings);
  return body;
}

}  // namespace poinsot::scene
