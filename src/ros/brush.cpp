#include "poinsot/ros/brush.h"

#include "poinsot/ros/conversions.h"
#include "poinsot/ros/palette.h"

namespace poinsot::node {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

Marker Brush::marker(const std::string& ns, int id, int type, const std::string& frame) const {
  Marker out;
  out.header.frame_id = frame;
  out.ns = ns;
  out.id = id;
  out.type = type;
  out.action = Marker::ADD;
  out.pose.orientation.w = 1;
  return out;
}

std::string Brush::ns(LabelId id) const {
  switch (id) {
    case kMomentumSymbol:
    case kOmegaPointer:
    case kOmegaSymbol:
      return ns(names::kSpace, names::kLabel);
    default:
      return ns(names::kLabel);
  }
}

Marker Brush::text(LabelId id, const std::string& frame, const Eigen::Vector3d& place, const std::string& words,
                   double height) const {
  Marker out = marker(ns(id), id, Marker::TEXT_VIEW_FACING, frame);
  out.pose.position = toPoint(place);
  out.text = words;
  out.scale.z = height;
  out.color = palette::label();
  return out;
}

Marker Brush::arrow(const std::string& ns, int id, const std::string& frame, const Eigen::Vector3d& from,
                    const Eigen::Vector3d& tip) const {
  Marker out = marker(ns, id, Marker::ARROW, frame);
  out.points = {toPoint(from), toPoint(tip)};
  out.scale = toVector3({kShaft, kHead, kHeadLength});
  return out;
}

void makeUnlit(Marker& triangles) {
  triangles.colors.assign(triangles.points.size(), triangles.color);
}

void Stage::put(const Marker& marker, MarkerArray& out) {
  there_[{marker.ns, marker.id}] = marker.header.frame_id;
  out.markers.push_back(marker);
}

std::map<Stage::Key, std::string>::iterator Stage::withdraw(std::map<Key, std::string>::iterator it, MarkerArray& out) {
  Marker gone;
  gone.header.frame_id = it->second;
  gone.ns = it->first.first;
  gone.id = it->first.second;
  gone.action = Marker::DELETE;
  gone.pose.orientation.w = 1;
  out.markers.push_back(gone);
  return there_.erase(it);
}

void Stage::withdraw(const std::string& ns, int first_id, MarkerArray& out) {
  auto it = there_.lower_bound({ns, first_id});
  while (it != there_.end() && it->first.first == ns) it = withdraw(it, out);
}

void Stage::withdrawOne(const std::string& ns, int id, MarkerArray& out) {
  const auto it = there_.find({ns, id});
  if (it != there_.end()) withdraw(it, out);
}

}  // namespace poinsot::node
