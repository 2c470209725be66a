#include "poinsot/ros/markers/marker_tracker.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>

#include "markers/marker_factory.h"
#include "poinsot/ros/markers/palette.h"
#include "poinsot/ros/names.h"

namespace poinsot::node {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

Marker deletion(const MarkerKey& key, const std::string& frame) {
  Marker out;
  out.header.frame_id = frame;
  out.ns = key.first;
  out.id = key.second;
  out.action = Marker::DELETE;
  out.pose.orientation.w = 1;
  return out;
}

/** Whether the scale of a marker is the width of what its points give. */
bool hasWidth(const Marker& marker) {
  return marker.type == Marker::ARROW || marker.type == Marker::LINE_STRIP || marker.type == Marker::LINE_LIST;
}

template <class Vector>
void multiply(Vector& vector, double factor) {
  vector.x *= factor;
  vector.y *= factor;
  vector.z *= factor;
}

constexpr int kParts = 16;  // of a shape; those of a node that has ended and drew more stay where they are
constexpr int kEffectIds = 5;
constexpr int kMostGhosts = 9 * kParts;
constexpr std::size_t kMostCleared = 100;  // bodies

}  // namespace

std::map<std::string, int> markerSpaces(const std::string& body) {
  using namespace names;
  std::map<std::string, int> out = {{markers(body, kShape), kParts},
                                    {markers(body, kTrail), kTrailIds},
                                    {markers(body, kLabel), kLabelIds},
                                    {markers(body, kTorque), kEffectIds},
                                    {markers(body, kGravity), kEffectIds},
                                    {markers(body, kSpace, kLabel), kLabelIds},
                                    {markers(body, kAxes), 1},
                                    {markers(body, kPath), 1},
                                    {markers(body, kGhosts), kMostGhosts},
                                    {markers(body, kOrbit), 2 + kParts}};
  const auto add = [&](const char* picture, int ids, std::initializer_list<const char*> whats) {
    for (const char* what : whats) out[markers(body, picture, what)] = ids;
  };
  for (const char* picture : {kSpace, kModel}) {
    add(picture, 1, {kEnergyEllipsoid, kMomentumEllipsoid, kAxes, kOmega});
    add(picture, kCurveIds, {kPolhode, kSeparatrix});
  }
  add(kSpace, 1, {kAngularMomentum, kHerpolhode, kInvariablePlane, kMontgomery});
  add(kSpace, 2, {kBodyCone, kSpaceCone});
  add(kModel, 2, {kPolhodeFamily});
  return out;
}

void Canvas::setUnits(const names::Frames& frames, double unit, double text, bool light) {
  picture_frames_ = {frames.space, frames.space_body, frames.model};
  unit_ = unit;
  text_ = text;
  light_ = light;
}

void Canvas::put(const Marker& marker) {
  there_[{marker.ns, marker.id}] = marker.header.frame_id;
  markers_.push_back(marker);
  Marker& out = markers_.back();
  const bool in_picture = picture_frames_.count(out.header.frame_id) > 0;
  if (in_picture) {
    multiply(out.pose.position, unit_);
    for (geometry_msgs::Point& point : out.points) multiply(point, unit_);
  }
  if (out.type == Marker::TEXT_VIEW_FACING) {
    out.scale.z *= unit_ * text_;
    out.color = palette::asText(out.color, light_);
  } else if (out.type != Marker::TRIANGLE_LIST && (in_picture || hasWidth(out))) {
    multiply(out.scale, unit_);
  }
}

void Canvas::show(bool shown, const Marker& marker) {
  if (shown) return put(marker);
  remove(marker.ns, marker.id, marker.id + 1);
}

void Canvas::remove(const std::string& ns, int first_id, int end_id) {
  auto it = there_.lower_bound({ns, first_id});
  while (it != there_.end() && it->first < MarkerKey(ns, end_id)) {
    markers_.push_back(deletion(it->first, it->second));
    it = there_.erase(it);
  }
}

void MarkerTracker::withdraw(const std::string& body) {
  const std::string prefix = names::markers(body, "");
  for (auto it = there_.lower_bound({prefix, 0});
       it != there_.end() && it->first.compare(0, prefix.size(), prefix) == 0; ++it) {
    to_go_.insert(*it);
  }
}

void MarkerTracker::withdrawLeftovers(const std::vector<std::string>& bodies) {
  if (bodies.size() > kMostCleared) return;
  for (const std::string& body : bodies) {
    for (const auto& [ns, ids] : markerSpaces(body)) {
      for (int id = 0; id < ids; ++id) {
        const MarkerKey key(ns, id);
        if (there_.count(key) == 0) to_go_.insert(key);
      }
    }
  }
}

void MarkerTracker::follow(MarkerArray& array) {
  for (const Marker& marker : array.markers) {
    const MarkerKey key(marker.ns, marker.id);
    to_go_.erase(key);
    gone_.erase(key);
    if (marker.action == Marker::ADD) {
      there_.insert(key);
    } else {
      there_.erase(key);
    }
  }
  if (to_go_.empty()) return;
  std::vector<Marker> markers;
  markers.reserve(to_go_.size() + array.markers.size());
  for (const MarkerKey& key : to_go_) {
    // In the world's frame, so that RViz takes it in turn with the others, also where the marker's own frame has gone.
    markers.push_back(deletion(key, names::kWorld));
    there_.erase(key);
  }
  gone_.insert(to_go_.begin(), to_go_.end());
  to_go_.clear();
  std::move(array.markers.begin(), array.markers.end(), std::back_inserter(markers));
  array.markers = std::move(markers);
}

}  // namespace poinsot::node
