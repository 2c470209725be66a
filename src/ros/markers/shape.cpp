#include <boost/algorithm/string/predicate.hpp>
#include <string>
#include <vector>

#include "markers/parts.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/markers/meshes.h"
#include "poinsot/ros/markers/palette.h"

namespace poinsot::node::parts {
namespace {

Marker markerOf(const Solid& solid, int colour) {
  Marker marker;
  marker.type = solid.type == SolidType::ellipsoid  ? Marker::SPHERE
                : solid.type == SolidType::cylinder ? Marker::CYLINDER
                                                    : Marker::CUBE;
  marker.pose.position = toPoint(solid.centre);
  marker.pose.orientation = toQuaternion(solid.orientation);
  marker.scale = toVector3(solid.size);
  marker.color = palette::kParts[colour % 3];
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

}  // namespace

void appendShape(const Subject& subject, Canvas& canvas) {
  const auto put = [&](Marker marker, int id) {
    marker.header.frame_id = subject.factory.frames().body;
    marker.ns = subject.factory.ns(names::kShape);
    marker.id = id;
    marker.frame_locked = true;
    canvas.put(marker);
  };
  if (subject.appearance) return put(markerOf(*subject.appearance), 0);
  const bool single = subject.shape.parts().size() == 1;
  const std::vector<Solid> solids = single ? toldApart(subject.shape.parts().front()) : subject.shape.parts();
  for (std::size_t i = 0; i < solids.size(); ++i) {
    Solid solid = solids[i];
    solid.centre += subject.shape_position;
    // The second half of a single solid takes the brightest colour.
    put(markerOf(solid, static_cast<int>(single && i == 1 ? 2 : i)), static_cast<int>(i));
  }
}

}  // namespace poinsot::node::parts
