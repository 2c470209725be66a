#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "markers/layout.h"
#include "markers/parts.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/markers/meshes.h"
#include "poinsot/ros/markers/palette.h"

namespace poinsot::node::parts {
namespace {

Marker markerOf(const Solid& solid, const std_msgs::ColorRGBA& colour) {
  Marker marker;
  marker.type = solid.type == SolidType::ellipsoid  ? Marker::SPHERE
                : solid.type == SolidType::cylinder ? Marker::CYLINDER
                                                    : Marker::CUBE;
  marker.pose.position = toPoint(solid.centre);
  marker.pose.orientation = toQuaternion(solid.orientation);
  marker.scale = toVector3(solid.size);
  marker.color = colour;
  return marker;
}

/** A single solid looks the same from both ends: cut it in two, or give an ellipsoid a nose. */
std::vector<Solid> toldApart(const Solid& solid) {
  Eigen::Index longest = 2;
  if (solid.type != SolidType::cylinder) solid.size.maxCoeff(&longest);
  const Eigen::Vector3d along = solid.orientation * Eigen::Vector3d::Unit(longest);
  Solid first = solid, second = solid;
  if (solid.type == SolidType::ellipsoid) {
    second.size = 0.3 * solid.size;
    second.centre += 0.42 * solid.size[longest] * along;
  } else {
    first.size[longest] *= 0.5;
    second.size[longest] *= 0.5;
    first.centre -= 0.25 * solid.size[longest] * along;
    second.centre += 0.25 * solid.size[longest] * along;
  }
  return {first, second};
}

Marker markerOf(const scene::Appearance& appearance) {
  Marker marker;
  marker.type = Marker::MESH_RESOURCE;
  marker.mesh_resource = meshAddress(appearance.mesh);
  marker.pose.position = toPoint(appearance.position);
  marker.pose.orientation = toQuaternion(appearance.orientation);
  marker.scale = toVector3(appearance.scale);
  marker.mesh_use_embedded_materials = boost::algorithm::iends_with(appearance.mesh, ".dae");
  // RViz tints a mesh that has colours of its own, by white too; a colour of all zeros leaves them alone.
  if (!marker.mesh_use_embedded_materials) marker.color = palette::kParts[0];
  return marker;
}

std_msgs::ColorRGBA colourOf(const Subject& subject, int i) {
  std_msgs::ColorRGBA out = palette::kParts[i % 3];
  if (!subject.colour) return out;
  // The parts stay apart: every second one is darker.
  const double shade = i % 2 == 0 ? 1 : 0.65;
  out.r = static_cast<float>(shade * subject.colour->x());
  out.g = static_cast<float>(shade * subject.colour->y());
  out.b = static_cast<float>(shade * subject.colour->z());
  return out;
}

bool isInside(const Solid& solid, const Eigen::Vector3d& point) {
  const Eigen::Vector3d p = (solid.orientation.conjugate() * (point - solid.centre)).cwiseQuotient(0.5 * solid.size);
  if (solid.type == SolidType::ellipsoid) return p.squaredNorm() <= 1;
  if (solid.type == SolidType::cylinder) return p.head<2>().squaredNorm() <= 1 && std::abs(p.z()) <= 1;
  return p.cwiseAbs().maxCoeff() <= 1;
}

/** How far from the body's origin a ray in that direction leaves the shape [m]. */
double exitOf(const Subject& subject, const Eigen::Vector3d& direction) {
  constexpr int kSteps = 100;
  for (int i = kSteps; i > 0; --i) {
    const double distance = subject.reach * i / kSteps;
    for (const Solid& solid : subject.shape.parts()) {
      if (isInside(solid, distance * direction - subject.shape_position)) return distance;
    }
  }
  return 0;
}

constexpr int kGhosts = 8;
constexpr float kGhostAlpha = 0.22f;
constexpr int kFlightPieces = 60;
constexpr double kAxisEnd = 0.16;

}  // namespace

void appendShape(const Subject& subject, Canvas& canvas) {
  int id = 0;
  for (Marker& marker : shapeOf(subject)) {
    marker.header.frame_id = subject.factory.frames().body;
    marker.ns = subject.factory.ns(names::kShape);
    marker.id = id++;
    marker.frame_locked = true;
    canvas.put(marker);
  }
}

std::vector<Marker> shapeOf(const Subject& subject) {
  if (subject.appearance) return {markerOf(*subject.appearance)};
  const bool single = subject.shape.parts().size() == 1;
  const std::vector<Solid> solids = single ? toldApart(subject.shape.parts().front()) : subject.shape.parts();
  std::vector<Marker> out;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    Solid solid = solids[i];
    solid.centre += subject.shape_position;
    // The second half of a single solid takes the brightest colour.
    const int colour = static_cast<int>(single && i == 1 && !subject.colour ? 2 : i);
    out.push_back(markerOf(solid, colourOf(subject, colour)));
  }
  return out;
}

std::vector<Marker> copyOf(std::vector<Marker> shape, const Eigen::Vector3d& position,
                           const Eigen::Quaterniond& attitude, double size) {
  for (Marker& marker : shape) {
    marker.header.frame_id = names::kWorld;
    const Eigen::Vector3d in_body(marker.pose.position.x, marker.pose.position.y, marker.pose.position.z);
    const geometry_msgs::Quaternion& q = marker.pose.orientation;
    marker.pose.position = toPoint(position + attitude * (size * in_body));
    marker.pose.orientation = toQuaternion(attitude * Eigen::Quaterniond(q.w, q.x, q.y, q.z));
    marker.scale.x *= size;
    marker.scale.y *= size;
    marker.scale.z *= size;
  }
  return shape;
}

void appendBodyAxes(const Subject& subject, Canvas& canvas) {
  Marker m =
      locked(subject.factory.marker(subject.factory.ns(names::kAxes), 0, Marker::LINE_LIST,
                                    subject.factory.frames().body, {layout::kAxisWidth, 0, 0}, palette::kPolhode));
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d direction = subject.inertia.axes() * Eigen::Vector3d::Unit(axis);
    for (const Eigen::Vector3d& d : {direction, Eigen::Vector3d(-direction)}) {
      const double surface = exitOf(subject, d);
      m.points.push_back(toPoint(surface * d));
      m.points.push_back(toPoint((surface + kAxisEnd * subject.unit()) * d));
      m.colors.insert(m.colors.end(), 2, palette::kAxes[axis]);
    }
  }
  canvas.put(m);
}

void appendFlight(const Subject& subject, Canvas& canvas) {
  const std::optional<double>& loop = subject.frame.loop;
  if (!loop) return;
  Marker path = subject.factory.marker(subject.factory.ns(names::kPath), 0, Marker::LINE_STRIP, names::kWorld,
                                       {layout::kPathWidth, 0, 0}, palette::kFlight);
  for (int i = 0; i <= kFlightPieces; ++i) {
    path.points.push_back(toPoint(subject.translation->positionAt(*loop * i / kFlightPieces)));
  }
  canvas.put(path);

  const std::vector<Marker> shape = shapeOf(subject);
  int id = 0;
  for (int i = 0; i <= kGhosts; ++i) {
    const double t = *loop * i / kGhosts;
    const Eigen::Quaterniond attitude = subject.closed_form->at(t).attitude * subject.inertia.axes().conjugate();
    for (Marker& ghost : copyOf(shape, subject.translation->positionAt(t), attitude, 1)) {
      ghost.ns = subject.factory.ns(names::kGhosts);
      ghost.id = id++;
      ghost.mesh_use_embedded_materials = false;
      if (ghost.color.a == 0) ghost.color = palette::kParts[0];
      ghost.color.a = kGhostAlpha;
      canvas.put(ghost);
    }
  }
}

}  // namespace poinsot::node::parts
