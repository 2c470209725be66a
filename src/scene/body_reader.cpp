#include "body_reader.h"

#include <cmath>
#include <stdexcept>
#include <variant>

#include "appearance_reader.h"
#include "effect_reader.h"
#include "fields.h"
#include "inertia_reader.h"
#include "method_reader.h"
#include "number.h"
#include "poinsot/core/motion.h"
#include "shape_reader.h"
#include "words.h"

namespace poinsot::scene {
namespace {

constexpr double kSameMass = 1e-6;  // relative

const char* const kAllowedBody = "a body, such as {name: brick, inertia: [1, 2, 3], angular_velocity: [0, 1, 0]}";

/** The place with the body's name, if there is anything like one, for all messages that follow. */
Place withName(const Place& place) {
  if (!place.node().IsMap()) return place;
  const YAML::Node name = place.node()["name"];
  return name.IsDefined() && name.IsScalar() ? place.called(name.Scalar()) : place;
}

void checkKeys(const Fields& fields) {
  fields.allowOnly({"name", "inertia", "shape", "appearance", "attitude", "angular_velocity", "method", "step",
                    "accuracy", "horizon", "effects"});
}

void readInertiaOrShape(const Fields& fields, Body& body, std::vector<std::string>& warnings) {
  const auto inertia = fields.find("inertia");
  const auto shape = fields.find("shape");
  if (inertia && shape) fields.place().refuse("both inertia and shape are given", "exactly one of inertia, shape");
  if (!inertia && !shape) {
    fields.place().refuse("the key inertia or shape is missing", "exactly one of inertia, shape");
  }
  if (inertia) {
    body.inertia = readInertia(*inertia);
  } else {
    body.shape = readShape(*shape);
    try {
      body.inertia = PrincipalInertia::fromTensor(body.shape->inertiaTensor());
    } catch (const std::invalid_argument& objection) {
      shape->refuse(objection.what(), "lengths and masses whose volumes and moments doubles can hold");
    }
  }
  if (!body.inertia.satisfiesTriangleInequality()) {
    const Eigen::Vector3d& m = body.inertia.moments();
    warnings.push_back(
        (inertia ? inertia : shape)
            ->message(
                "the principal moments " + numberText(m[0], 15) + ", " + numberText(m[1], 15) + ", " +
                numberText(m[2], 15) +
                " kg·m² are those of no real body (one exceeds the sum of the other two); simulated all the same"));
  }
}

/**
 * A shape's moments are about its centre of mass; a body that hangs on a pivot turns about that (Steiner). Body axes
 * keep their directions.
 */
void movePivot(const Fields& fields, Body& body) {
  if (!body.shape) return;
  bool moved = false;
  for (const Effect& effect : body.effects) {
    const auto* weight = std::get_if<GravityTorque>(&effect);
    if (!weight) continue;
    if (moved) {
      fields.find("effects")->refuse("a second gravity_torque, and a shape has one weight",
                                     "one gravity_torque, or inertia instead of shape");
    }
    moved = true;
    const double mass = body.shape->mass();
    if (!(std::abs(weight->mass - mass) <= kSameMass * mass)) {
      fields.find("effects")->refuse("the mass of gravity_torque, " + numberText(weight->mass, 15) +
                                         " kg, is not that of the shape, " + numberText(mass, 15) + " kg",
                                     "the same mass in both");
    }
    const Eigen::Vector3d& c = weight->centre_of_mass;
    body.shape_position = c;
    try {
      body.inertia = PrincipalInertia::fromTensor(
          body.shape->inertiaTensor() + mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose()));
    } catch (const std::invalid_argument& objection) {
      fields.find("effects")->refuse("about the pivot of gravity_torque " + std::string(objection.what()),
                                     "a centre_of_mass so near the pivot that doubles hold the moments about it");
    }
  }
}

void readAngularVelocity(const Fields& fields, Body& body) {
  const Quantity& quantity = quantity::kAngularVelocity;
  const Place place = fields.require("angular_velocity", allowedNumbers(3, quantity));
  body.omega_body = readVector(place, quantity);
  const std::string problem = outOfRange(body.inertia, body.omega_body);
  if (!problem.empty()) {
    place.refuse("with this inertia " + problem,
                 "3 numbers (rad/s), all zero or such that energy and squared momentum are held in full precision");
  }
}

}  // namespace

Body readBody(const Place& unnamed, const ReadOptions& options, std::vector<std::string>& warnings) {
  const Fields fields(withName(unnamed), kAllowedBody);
  checkKeys(fields);

  Body body;
  body.name = readName(fields.require("name", "a letter, then letters, digits and underscores"));
  readInertiaOrShape(fields, body, warnings);
  if (const auto appearance = fields.find("appearance")) body.appearance = readAppearance(*appearance);
  if (const auto effects = fields.find("effects")) readEffects(*effects, body);
  movePivot(fields, body);
  if (const auto attitude = fields.find("attitude")) body.attitude = readRotation(*attitude);
  readAngularVelocity(fields, body);
  readMethod(fields, options, body, warnings);
  return body;
}

}  // namespace poinsot::scene
