#include "shape_reader.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "fields.h"
#include "number.h"

namespace poinsot::scene {
namespace {

constexpr double kHalfPi = 1.57079632679489661923;

/** A type of shape: its keys besides `type`, and the function that builds it from them. */
struct ShapeType {
  std::string name;
  std::vector<std::string> keys;
  Assembly (*make)(const Fields& fields);
};

double length(const Fields& fields, const char* key) {
  return requireNumber(fields, key, quantity::kLength);
}

double mass(const Fields& fields) {
  return requireNumber(fields, "mass", quantity::kMass);
}

Eigen::Vector3d size(const Fields& fields, const char* key) {
  return requireVector(fields, key, quantity::kLength);
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
  const double dihedral = requireNumber(f, "dihedral", quantity::kAngle);
  if (std::abs(dihedral) > kHalfPi) {
    const Place place = *f.find("dihedral");
    place.refuse("a number from -π/2 to π/2 (rad)", place.found());
  }
  return shapes::wingnut(length(f, "hub_radius"), length(f, "hub_height"), size(f, "wing_size"), dihedral, mass(f));
}

Assembly makeLShape(const Fields& f) {
  const double thickness = length(f, "thickness");
  const double length_z = length(f, "length_z");
  if (!(length_z > thickness)) {
    const Place place = *f.find("length_z");
    place.refuse("a finite number above the thickness " + numberText(thickness, 15) + " (m)", place.found());
  }
  return shapes::lShape(length(f, "length_x"), length_z, thickness, mass(f));
}

Assembly makeTwoCylinders(const Fields& f) {
  return shapes::twoCylinders(length(f, "radius"), length(f, "height"), length(f, "second_radius"),
                              length(f, "second_height"), requireVector(f, "offset", quantity::kPosition), mass(f));
}

/** Returns one part of an assembly, at the position and orientation that its keys give. */
Solid readPart(const Place& place) {
  const Fields fields(place, "a part, such as {type: box, size: [1, 1, 1], mass: 1}");
  const std::string type = fields.requireChoice("type", {"box", "ellipsoid", "cylinder"});
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
  const char* const expected = "a list of at least one part";
  const Place list = f.require("parts", expected);
  list.requireList(expected, 1);
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
  const Fields fields(place, "a shape, such as {type: box, size: [1, 1, 1], mass: 1}");
  const ShapeType& type = fields.requireType(shapeTypes());
  try {
    const Assembly shape = type.make(fields);
    if (!std::isfinite(shape.mass())) place.refuse(kExpectedSizes, "masses that have no finite sum");
    return shape;
  } catch (const std::invalid_argument& objection) {  // volumes or products beyond the range of doubles
    place.refuse(kExpectedSizes, "others", objection.what());
  }
}

}  // namespace poinsot::scene
