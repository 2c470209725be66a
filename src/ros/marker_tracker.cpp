#include "poinsot/ros/marker_tracker.h"

#include <algorithm>
#include <iterator>

#include "poinsot/ros/marker_factory.h"
#include "poinsot/ros/names.h"

namespace poinsot::node {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

Marker deletion(const std::string& ns, int id, const std::string& frame) {
  Marker out;
  out.header.frame_id = frame;
  out.ns = ns;
  out.id = id;
  out.action = Marker::DELETE;
  out.pose.orientation.w = 1;
  return out;
}

constexpr int kParts = 16;  // of a shape; those of a node that has ended and drew more stay where they are
constexpr int kEffectIds = 5;
constexpr std::size_t kMostCleared = 100;  // bodies

}  // namespace

std::vector<MarkerSpace> markerSpaces(const std::string& body) {
  std::vector<MarkerSpace> out;
  const auto add = [&](const char* what, int ids) { out.push_back({names::markers(body, what), ids}); };
  const auto addIn = [&](const char* picture, const char* what, int ids) {
    out.push_back({names::markers(body, picture, what), ids});
  };
  add(names::kShape, kParts);
  add(names::kTrail, kTrailIds);
  add(names::kLabel, kLabelIds);
  add(names::kTorque, kEffectIds);
  add(names::kGravity, kEffectIds);
  for (const char* picture : {names::kSpace, names::kModel}) {
    for (const char* what : {names::kEnergyEllipsoid, names::kMomentumEllipsoid, names::kOmega})
      addIn(picture, what, 1);
    for (const char* what : {names::kPolhode, names::kSeparatrix}) addIn(picture, what, kCurveIds);
  }
  addIn(names::kSpace, names::kLabel, kLabelIds);
  for (const char* what : {names::kAngularMomentum, names::kHerpolhode, names::kInvariablePlane, names::kMontgomery}) {
    addIn(names::kSpace, what, 1);
  }
  addIn(names::kSpace, names::kBodyCone, 2);
  addIn(names::kSpace, names::kSpaceCone, 2);
  addIn(names::kModel, names::kPolhodeFamily, 2);
  return out;
}

void MarkerTracker::put(const Marker& marker, MarkerArray& out) {
  there_[{marker.ns, marker.id}] = marker.header.frame_id;
  out.markers.push_back(marker);
}

MarkerTracker::Frames::iterator MarkerTracker::remove(Frames::iterator it, MarkerArray& out) {
  out.markers.push_back(deletion(it->first.first, it->first.second, it->second));
  return there_.erase(it);
}

void MarkerTracker::remove(const std::string& ns, int first_id, MarkerArray& out) {
  auto it = there_.lower_bound({ns, first_id});
  while (it != there_.end() && it->first.first == ns) it = remove(it, out);
}

void MarkerTracker::removeOne(const std::string& ns, int id, MarkerArray& out) {
  const auto it = there_.find({ns, id});
  if (it != there_.end()) remove(it, out);
}

void MarkerTracker::withdraw(const std::string& body) {
  const std::string prefix = names::markers(body, "");
  for (auto it = there_.lower_bound({prefix, 0});
       it != there_.end() && it->first.first.compare(0, prefix.size(), prefix) == 0; ++it) {
    to_go_.insert(it->first);
  }
}

void MarkerTracker::withdrawAll() {
  for (const auto& [key, frame] : there_) to_go_.insert(key);
}

void MarkerTracker::withdrawLeftovers(const std::vector<std::string>& bodies) {
  if (bodies.size() > kMostCleared) return;
  for (const std::string& body : bodies) {
    for (const MarkerSpace& space : markerSpaces(body)) {
      for (int id = 0; id < space.ids; ++id) {
        const Key key(space.ns, id);
        if (there_.count(key) == 0) to_go_.insert(key);
      }
    }
  }
}

void MarkerTracker::withdrawAgain() {
  to_go_.insert(gone_.begin(), gone_.end());
}

void MarkerTracker::follow(MarkerArray& array) {
  for (const Marker& marker : array.markers) {
    const Key key(marker.ns, marker.id);
    to_go_.erase(key);
    gone_.erase(key);
    if (marker.action == Marker::ADD) {
      there_[key] = marker.header.frame_id;
    } else {
      there_.erase(key);
    }
  }
  if (to_go_.empty()) return;
  std::vector<Marker> markers;
  markers.reserve(to_go_.size() + array.markers.size());
  for (const Key& key : to_go_) {
    // In the world's frame, so that RViz takes it in turn with the others, also where the marker's own frame has gone.
    markers.push_back(deletion(key.first, key.second, names::kWorld));
    there_.erase(key);
  }
  gone_.insert(to_go_.begin(), to_go_.end());
  to_go_.clear();
  std::move(array.markers.begin(), array.markers.end(), std::back_inserter(markers));
  array.markers = std::move(markers);
}

}  // namespace poinsot::node
