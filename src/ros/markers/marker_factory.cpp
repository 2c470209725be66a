#include "markers/marker_factory.h"

#include "poinsot/ros/conversions.h"

namespace poinsot::node {

using visualization_msgs::Marker;

std::string MarkerFactory::ns(LabelId id) const {
  const bool of_an_arrow = id == kMomentumSymbol || id == kOmegaPointer || id == kOmegaSymbol || id == kOmegaEnd;
  return of_an_arrow ? ns(names::kSpace, names::kLabel) : ns(names::kLabel);
}

Marker MarkerFactory::marker(const std::string& ns, int id, int type, const std::string& frame,
                             const Eigen::Vector3d& scale, const std_msgs::ColorRGBA& colour) const {
  Marker out;
  out.header.frame_id = frame;
  out.ns = ns;
  out.id = id;
  out.type = type;
  out.action = Marker::ADD;
  out.pose.orientation.w = 1;
  out.scale = toVector3(scale);
  out.color = colour;
  return out;
}

Marker MarkerFactory::curve(const std::string& ns, int id, const std::string& frame, const view::Curve& curve,
                            double metres, double width, double diameter, const std_msgs::ColorRGBA& colour) const {
  const bool is_point = curve.points.size() == 1;  // RViz draws no line through a single point
  const Eigen::Vector3d scale = is_point ? Eigen::Vector3d::Constant(diameter) : Eigen::Vector3d(width, 0, 0);
  Marker out = locked(marker(ns, id, is_point ? Marker::SPHERE_LIST : Marker::LINE_STRIP, frame, scale, colour));
  for (const Eigen::Vector3d& p : curve.points) out.points.push_back(toPoint(metres * p));
  if (curve.closed && !is_point) out.points.push_back(out.points.front());
  return out;
}

Marker MarkerFactory::text(LabelId id, const std::string& frame, const Eigen::Vector3d& place, const std::string& words,
                           double height, const std_msgs::ColorRGBA& colour) const {
  Marker out = marker(ns(id), id, Marker::TEXT_VIEW_FACING, frame, {0, 0, height}, colour);
  out.pose.position = toPoint(place);
  out.text = words;
  return out;
}

Marker MarkerFactory::arrow(const std::string& ns, int id, const std::string& frame, const Eigen::Vector3d& from,
                            const Eigen::Vector3d& tip, const std_msgs::ColorRGBA& colour) const {
  constexpr double kShaft = 0.045, kHead = 0.115, kHeadLength = 0.17;
  Marker out = marker(ns, id, Marker::ARROW, frame, {kShaft, kHead, kHeadLength}, colour);
  out.points = {toPoint(from), toPoint(tip)};
  return out;
}

Marker locked(Marker marker) {
  marker.frame_locked = true;
  return marker;
}

void makeUnlit(Marker& triangles) {
  triangles.colors.assign(triangles.points.size(), triangles.color);
}

}  // namespace poinsot::node
