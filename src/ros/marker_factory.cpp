#include "poinsot/ros/marker_factory.h"

#include "poinsot/ros/conversions.h"
#include "poinsot/ros/palette.h"

namespace poinsot::node {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

Marker MarkerFactory::marker(const std::string& ns, int id, int type, const std::string& frame) const {
  Marker out;
  out.header.frame_id = frame;
  out.ns = ns;
  out.id = id;
  out.type = type;
  out.action = Marker::ADD;
  out.pose.orientation.w = 1;
  return out;
}

std::string MarkerFactory::ns(LabelId id) const {
  switch (id) {
    case kMomentumSymbol:
    case kOmegaPointer:
    case kOmegaSymbol:
      return ns(names::kSpace, names::kLabel);
    default:
      return ns(names::kLabel);
  }
}

Marker MarkerFactory::text(LabelId id, const std::string& frame, const Eigen::Vector3d& place, const std::string& words,
                           double height) const {
  Marker out = marker(ns(id), id, Marker::TEXT_VIEW_FACING, frame);
  out.pose.position = toPoint(place);
  out.text = words;
  out.scale.z = height;
  out.color = palette::label();
  return out;
}

Marker MarkerFactory::arrow(const std::string& ns, int id, const std::string& frame, const Eigen::Vector3d& from,
                            const Eigen::Vector3d& tip) const {
  Marker out = marker(ns, id, Marker::ARROW, frame);
  out.points = {toPoint(from), toPoint(tip)};
  out.scale = toVector3({kShaft, kHead, kHeadLength});
  return out;
}

void makeUnlit(Marker& triangles) {
  triangles.colors.assign(triangles.points.size(), triangles.color);
}

}  // namespace poinsot::node
