#include "poinsot/ros/shape_markers.h"

#include <boost/algorithm/string/predicate.hpp>

#include "poinsot/ros/conversions.h"
#include "poinsot/ros/meshes.h"
#include "poinsot/ros/palette.h"

namespace poinsot::node {
namespace {

int markerType(SolidType type) {
  switch (type) {
    case SolidType::box:
      return visualization_msgs::Marker::CUBE;
    case SolidType::ellipsoid:
      return visualization_msgs::Marker::SPHERE;
    case SolidType::cylinder:
      return visualization_msgs::Marker::CYLINDER;
  }
  return visualization_msgs::Marker::CUBE;
}

visualization_msgs::Marker markerOf(const Solid& solid, int colour) {
  visualization_msgs::Marker marker;
  marker.type = markerType(solid.type);
  marker.pose.position = toPoint(solid.centre);
  marker.pose.orientation = toQuaternion(solid.orientation);
  marker.scale = toVector3(solid.size);
  marker.color = palette::part(colour);
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

bool bringsColours(const std::string& mesh) {
  return boost::algorithm::iends_with(mesh, ".dae");
}

visualization_msgs::Marker markerOf(const scene::Appearance& appearance) {
  visualization_msgs::Marker marker;
  marker.type = visualization_msgs::Marker::MESH_RESOURCE;
  marker.mesh_resource = meshAddress(appearance.mesh);
  marker.pose.position = toPoint(appearance.position);
  marker.pose.orientation = toQuaternion(appearance.orientation);
  marker.scale = toVector3(appearance.scale);
  marker.mesh_use_embedded_materials = bringsColours(appearance.mesh);
  // RViz tints a mesh that has colours of its own, by white too; a colour of all zeros leaves them alone.
  if (!marker.mesh_use_embedded_materials) marker.color = palette::part(0);
  return marker;
}

}  // namespace

std::vector<visualization_msgs::Marker> shapeMarkers(const std::optional<scene::Appearance>& appearance,
                                                     const Assembly& shape, const Eigen::Vector3d& centre) {
  if (appearance) return {markerOf(*appearance)};
  const bool single = shape.parts().size() == 1;
  const std::vector<Solid> parts = single ? toldApart(shape.parts().front()) : shape.parts();
  std::vector<visualization_msgs::Marker> out;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    // The second half of a single solid takes the brightest colour.
    Solid part = parts[i];
    part.centre += centre;
    out.push_back(markerOf(part, static_cast<int>(single && i == 1 ? 2 : i)));
    out.back().id = static_cast<int>(i);
  }
  return out;
}

}  // namespace poinsot::node
