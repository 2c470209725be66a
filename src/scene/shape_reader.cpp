#include "shape_reader.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "fields.h"
#include "number.h"
#include "words.h"

namespace poinsot::scene {
namespace {

constexpr double kHalfPi = 1.57079632679489661923;

/** A type of shape: its keys besides `type`, and what builds it from them. */
struct ShapeType {
  const char* name;
  std::vector<std::string> keys;
  Assembly (*make)(const Fields& fields);
};

double positive(const Fields& fields, const char* key, const Quantity& quantity) {
  return readNumber(fields.require(key, allowedNumber(quantity)), quantity);
}

double length(const Fields& fields, const char* key) {
  return positive(fields, key, quantity::kLength);
}

double mass(const Fields& fields) {
  return positive(fields, "mass", quantity::kMass);
}

Eigen::Vector3d vector(const Fields& fields, const char* key, const Quantity& quantity) {
  return readVector(fields.require(key, allowedNumbers(3, quantity)), quantity);
}

Eigen::Vector3d size(const Fields& fields, const char* key) {
  return vector(fields, key, quantity::kLength);
}

Assembly makeBox(const Fields& f) {
  return shapes::box(size(f, "size"), mass(f));
}

Assembly makeEllipsoid(const Fields& f) {
  return shapes::ellipsoid(size(f, "size"), mass(f));
}

Assembly makeCylinder(const Fields& f) {
  return shapes::cylinder(length(f, "radius"), length(f, "height"), mass(f));
}

Assembly makeTHandle(const Fields& f) {
  return shapes::tHandle(length(f, "bar_radius"), length(f, "bar_length"), length(f, "stem_radius"),
                         length(f, "stem_length"), mass(f));
}

Assembly makeWingnut(const Fields& f) {
  const Place place = f.require("dihedral", allowedNumber(quantity::kAngle));
  const double dihedral = readNumber(place, quantity::kAngle);
  if (std::abs(dihedral) > kHalfPi) place.refuse(place.found() + " is too steep", "a number from -π/2 to π/2 (rad)");
  return shapes::wingnut(length(f, "hub_radius"), length(f, "hub_height"), size(f, "wing_size"), dihedral, mass(f));
}

Assembly makeLShape(const Fields& f) {
  const double thickness = length(f, "thickness");
  const double length_z = length(f, "length_z");
  if (!(length_z > thickness)) {
    const Place place = *f.find("length_z");
    place.refuse(place.found() + " is not more than the thickness",
                 "a finite number above the thickness " + numberText(thickness, 15) + " (m)");
  }
  return shapes::lShape(length(f, "length_x"), length_z, thickness, mass(f));
}

Assembly makeTwoCylinders(const Fields& f) {
  return shapes::twoCylinders(length(f, "radius"), length(f, "height"), length(f, "second_radius"),
                              length(f, "second_height"), vector(f, "offset", quantity::kPosition), mass(f));
}

/** One part of an assembly, placed where its keys say. */
Solid readPart(const Place& place) {
  const Fields fields(place, "a part, such as {type: box, size: [1, 1, 1], mass: 1}");
  const std::string type =
      readChoice(fields.require("type", "one of box, ellipsoid, cylinder"), {"box", "ellipsoid", "cylinder"});
  Solid part;
  if (type == "cylinder") {
    fields.allowOnly({"type", "radius", "height", "mass", "position", "orientation"});
    const double diameter = 2 * length(fields, "radius");
    part.type = SolidType::cylinder;
    part.size = {diameter, diameter, length(fields, "height")};
  } else {
    fields.allowOnly({"type", "size", "mass", "position", "orientation"});
    part.type = type == "box" ? SolidType::box : SolidType::ellipsoid;
    part.size = size(fields, "size");
  }
  part.mass = mass(fields);
  if (const auto position = fields.find("position")) part.centre = readVector(*position, quantity::kPosition);
  if (const auto orientation = fields.find("orientation")) part.orientation = readRotation(*orientation);
  return part;
}

Assembly makeAssembly(const Fields& f) {
  const char* const allowed = "a list of at least one part";
  const Place list = f.require("parts", allowed);
  list.requireList(allowed);
  if (list.node().size() == 0) list.refuse("an empty list has no parts", allowed);
  std::vector<Solid> parts;
  for (std::size_t i = 0; i < list.node().size(); ++i) parts.push_back(readPart(list.item(i)));
  return Assembly(std::move(parts));
}

const std::vector<ShapeType>& shapeTypes() {
  static const std::vector<ShapeType> table = {
      {"box", {"size", "mass"}, makeBox},
      {"ellipsoid", {"size", "mass"}, makeEllipsoid},
      {"cylinder", {"radius", "height", "mass"}, makeCylinder},
      {"t_handle", {"bar_radius", "bar_length", "stem_radius", "stem_length", "mass"}, makeTHandle},
      {"wingnut", {"hub_radius", "hub_height", "wing_size", "dihedral", "mass"}, makeWingnut},
      {"l_shape", {"length_x", "length_z", "thickness", "mass"}, makeLShape},
      {"two_cylinders", {"radius", "height", "second_radius", "second_height", "offset", "mass"}, makeTwoCylinders},
      {"assembly", {"parts"}, makeAssembly},
  };
  return table;
}

}  // namespace

Assembly readShape(const Place& place) {
  std::vector<std::string> names;
  for (const ShapeType& type : shapeTypes()) names.push_back(type.name);

  const Fields fields(place, "a shape, such as {type: box, size: [1, 1, 1], mass: 1}");
  const std::string name = readChoice(fields.require("type", "one of " + joined(names)), names);
  for (const ShapeType& type : shapeTypes()) {
    if (name != type.name) continue;
    std::vector<std::string> keys = {"type"};
    keys.insert(keys.end(), type.keys.begin(), type.keys.end());
    fields.allowOnly(keys);
    const char* const allowed = "lengths and masses whose volumes and moments doubles can hold";
    try {
      const Assembly shape = type.make(fields);
      if (!std::isfinite(shape.mass())) place.refuse("the masses have no finite sum", allowed);
      return shape;
    } catch (const std::invalid_argument& objection) {  // volumes or products beyond the range of doubles
      place.refuse(objection.what(), allowed);
    }
  }
  throw std::logic_error("a type of shape that is chosen but not in the table");
}

}  // namespace poinsot::scene
