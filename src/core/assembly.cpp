#include "poinsot/core/assembly.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "poinsot/core/pi.h"
#include "refuse.h"

namespace poinsot {
namespace {

constexpr double kThinnestSide = 0.02;  // of an equivalent box, as a share of its longest side

/** A form relative to the box of its extents. */
struct Form {
  double numerator, denominator;   ///< of its volume, as a share of that of the box
  Eigen::Vector3d second_moments;  ///< the mean of (x/w)², w the extent, for each of the three axes
};

const Form& formOf(SolidType type) {
  // In the order of SolidType.
  static const std::array<Form, 3> forms = {Form{1, 1, {1.0 / 12, 1.0 / 12, 1.0 / 12}},
                                            {kPi, 6, {1.0 / 20, 1.0 / 20, 1.0 / 20}},
                                            {kPi, 4, {1.0 / 16, 1.0 / 16, 1.0 / 12}}};
  return forms.at(static_cast<std::size_t>(type));
}

/** Gives each part the share of `mass` that its volume has. */
Assembly ofOneDensity(std::vector<Solid> parts, double mass) {
  double volume = 0;
  for (const Solid& part : parts) volume += part.volume();
  for (Solid& part : parts) part.mass = mass * (part.volume() / volume);
  return Assembly(std::move(parts));
}

Solid solid(SolidType type, const Eigen::Vector3d& size, const Eigen::Vector3d& centre = Eigen::Vector3d::Zero(),
            const Quaternion& orientation = Eigen::Quaterniond::Identity()) {
  return {type, size, 1, centre, orientation};
}

Eigen::Quaterniond about(double angle, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

}  // namespace

double Solid::volume() const {
  return size.prod() * formOf(type).numerator / formOf(type).denominator;
}

Eigen::Matrix3d Solid::inertiaTensor() const {
  const Eigen::Vector3d s = mass * formOf(type).second_moments.cwiseProduct(size.cwiseProduct(size));
  const Eigen::Vector3d moments(s.y() + s.z(), s.z() + s.x(), s.x() + s.y());
  if (orientation.vec().isZero(0)) return moments.asDiagonal();
  const Eigen::Matrix3d r = orientation.toRotationMatrix();
  return r * moments.asDiagonal() * r.transpose();
}

Assembly::Assembly(std::vector<Solid> parts) : parts_(std::move(parts)) {
  if (parts_.empty()) refuse("expected an assembly of at least one part, got none");
  double mass = 0;
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
  for (const Solid& part : parts_) {
    for (int i = 0; i < 3; ++i) requirePositive(part.size[i], "length", "m");
    requirePositive(part.mass, "mass", "kg");
    mass += part.mass;
    weighted += part.mass * part.centre;
  }
  const Eigen::Vector3d centre_of_mass = weighted / mass;
  for (Solid& part : parts_) part.centre -= centre_of_mass;
}

double Assembly::mass() const {
  double sum = 0;
  for (const Solid& part : parts_) sum += part.mass;
  return sum;
}

Eigen::Matrix3d Assembly::inertiaTensor() const {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Solid& part : parts_) {
    const Eigen::Vector3d& c = part.centre;
    sum += part.inertiaTensor() + part.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
  }
  return sum;
}

double Assembly::boundingRadius() const {
  double radius = 0;
  for (const Solid& part : parts_) {
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d signs(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
      radius = std::max(radius, (part.centre + part.orientation * signs.cwiseProduct(part.size)).norm());
    }
  }
  return radius;
}

namespace shapes {

Assembly box(const Eigen::Vector3d& size, double mass) {
  return ofOneDensity({solid(SolidType::box, size)}, mass);
}

Assembly ellipsoid(const Eigen::Vector3d& size, double mass) {
  return ofOneDensity({solid(SolidType::ellipsoid, size)}, mass);
}

Assembly cylinder(double radius, double height, double mass) {
  return ofOneDensity({solid(SolidType::cylinder, {2 * radius, 2 * radius, height})}, mass);
}

Assembly tHandle(double bar_radius, double bar_length, double stem_radius, double stem_length, double mass) {
  return ofOneDensity({solid(SolidType::cylinder, {2 * bar_radius, 2 * bar_radius, bar_length}, Eigen::Vector3d::Zero(),
                             about(kPi / 2, Eigen::Vector3d::UnitX())),
                       solid(SolidType::cylinder, {2 * stem_radius, 2 * stem_radius, stem_length},
                             {0, 0, bar_radius + 0.5 * stem_length})},
                      mass);
}

Assembly wingnut(double hub_radius, double hub_height, const Eigen::Vector3d& wing_size, double dihedral, double mass) {
  std::vector<Solid> parts = {solid(SolidType::cylinder, {2 * hub_radius, 2 * hub_radius, hub_height})};
  const Eigen::Vector3d disc(wing_size.x(), wing_size.z(), wing_size.y());  // a cylinder's axis is its z
  const Eigen::Quaterniond upright = about(kPi / 2, Eigen::Vector3d::UnitX());
  for (const double side : {1.0, -1.0}) {
    // A right wing turned about y by −dihedral rises outwards; the left one is its mirror image.
    const Eigen::Quaterniond turn = about(-side * dihedral, Eigen::Vector3d::UnitY());
    const Eigen::Vector3d root(side * 0.8 * hub_radius, 0, 0);
    parts.push_back(solid(SolidType::cylinder, disc, root + turn * Eigen::Vector3d(side * 0.5 * wing_size.x(), 0, 0),
                          turn * upright));
  }
  return ofOneDensity(std::move(parts), mass);
}

Assembly lShape(double length_x, double length_z, double thickness, double mass) {
  const double t = thickness;
  return ofOneDensity({solid(SolidType::box, {length_x, t, t}, {0.5 * (length_x - t), 0, 0}),
                       solid(SolidType::box, {t, t, length_z - t}, {0, 0, 0.5 * length_z})},
                      mass);
}

Assembly twoCylinders(double radius, double height, double second_radius, double second_height,
                      const Eigen::Vector3d& offset, double mass) {
  return ofOneDensity({solid(SolidType::cylinder, {2 * radius, 2 * radius, height}),
                       solid(SolidType::cylinder, {2 * second_radius, 2 * second_radius, second_height}, offset,
                             about(kPi / 2, Eigen::Vector3d::UnitY()))},
                      mass);
}

Assembly equivalentBox(const Eigen::Vector3d& moments, const Quaternion& axes) {
  const Eigen::Vector3d ratios = moments / moments.maxCoeff();
  const double sum = ratios.sum();
  Eigen::Vector3d size;
  for (int i = 0; i < 3; ++i) size[i] = std::sqrt(std::max(0.0, sum - 2 * ratios[i]));
  size = size.cwiseMax(kThinnestSide * size.maxCoeff());
  size *= 2 / size.norm();
  return Assembly({solid(SolidType::box, size, Eigen::Vector3d::Zero(), axes)});
}

}  // namespace shapes
}  // namespace poinsot
