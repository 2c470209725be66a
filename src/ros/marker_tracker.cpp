#include "poinsot/ros/marker_tracker.h"

#include <algorithm>
#include <iterator>

#include "poinsot/ros/brush.h"
#include "poinsot/ros/names.h"

namespace poinsot::node {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/** In the world's frame, so that RViz takes it in turn with the others whatever frames there are. */
Marker deletion(const std::string& ns, int id) {
  Marker out;
  out.header.frame_id = names::kWorld;
  out.ns = ns;
  out.id = id;
  out.action = Marker::DELETE;
  out.pose.orientation.w = 1;
  return out;
}

constexpr int kParts = 64;  // of a shape; those of a node that has ended and drew more stay where they are
constexpr int kEffectIds = 5;

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

void MarkerTracker::withdraw(const std::string& body) {
  const std::string prefix = names::markers(body, "");
  for (auto it = there_.lower_bound({prefix, 0});
       it != there_.end() && it->first.compare(0, prefix.size(), prefix) == 0; ++it) {
    to_go_.insert(*it);
  }
}

void MarkerTracker::withdrawAll() {
  to_go_.insert(there_.begin(), there_.end());
}

void MarkerTracker::withdrawLeftovers(const std::string& body) {
  for (const MarkerSpace& space : markerSpaces(body)) {
    for (int id = 0; id < space.ids; ++id) to_go_.insert({space.ns, id});
  }
}

void MarkerTracker::follow(MarkerArray& array) {
  for (const Marker& marker : array.markers) {
    const Key key(marker.ns, marker.id);
    to_go_.erase(key);
    if (marker.action == Marker::ADD) {
      there_.insert(key);
    } else {
      there_.erase(key);
    }
  }
  if (to_go_.empty()) return;
  std::vector<Marker> markers;
  markers.reserve(to_go_.size() + array.markers.size());
  for (const Key& key : to_go_) {
    markers.push_back(deletion(key.first, key.second));
    there_.erase(key);
  }
  to_go_.clear();
  std::move(array.markers.begin(), array.markers.end(), std::back_inserter(markers));
  array.markers = std::move(markers);
}

}  // namespace poinsot::node
