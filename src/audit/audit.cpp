#include "poinsot/audit/audit.h"

#include <ros/serialization.h>

#include <algorithm>
#include <functional>

#include "checks.h"

namespace poinsot::audit {
namespace {

std::string parentOf(const std::string& topic) {
  return topic.substr(0, std::min(topic.rfind('/'), topic.size()));
}

std::string withSlash(const std::string& topic) {
  return topic.empty() || topic[0] != '/' ? "/" + topic : topic;
}

/** Returns "/a/wingnut" for "/a/wingnut/state"; a topic with another name is its own key. */
std::string keyOf(const std::string& topic, const char* name) {
  const std::string absolute = withSlash(topic);
  return endsWith(absolute, std::string("/") + name) ? parentOf(absolute) : absolute;
}

}  // namespace

template <class Message>
bool Audit::isRepeated(const Message& message, const std::string& topic) {
  std::string bytes(ros::serialization::serializationLength(message), '\0');
  ros::serialization::OStream out(reinterpret_cast<std::uint8_t*>(&bytes[0]), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(out, message);
  return !heard_.insert(std::hash<std::string>()(topic + bytes)).second;
}

void Audit::add(const BodyState& message, const std::string& topic) {
  const std::string key = keyOf(topic, "state");
  Body& body = states_[key];
  body.key = key;
  body.name = message.body;
  if (isRepeated(message, topic)) {
    body.repeats = true;
  } else {
    body.states.push_back(read(message));
  }
}

void Audit::add(const BodyDescription& message, const std::string& topic) {
  descriptions_[keyOf(topic, "description")].push_back(read(message));
}

void Audit::add(const nav_msgs::Odometry& message, const std::string& topic) {
  if (isRepeated(message, topic)) return;
  odometry_[keyOf(topic, "odometry")].add(stampOf(message.header.stamp), read(message));
}

void Audit::add(const tf2_msgs::TFMessage& message, bool is_static) {
  for (const geometry_msgs::TransformStamped& t : message.transforms) {
    if (!is_static && isRepeated(t, "tf")) continue;
    transforms_.add(frameName(t.child_frame_id), stampOf(t.header.stamp), read(t), is_static);
  }
}

void Audit::add(const visualization_msgs::MarkerArray& message, const std::string& topic) {
  std::vector<Drawing>& drawings = drawings_[parentOf(withSlash(topic))];
  for (const visualization_msgs::Marker& marker : message.markers) {
    if (marker.action != visualization_msgs::Marker::ADD) continue;
    // Markers that do not change are sent again for each new viewer: one copy is enough.
    if (marker.header.stamp.isZero() && isRepeated(marker, topic)) continue;
    drawings.push_back(read(marker));
  }
}

void Audit::add(const SceneLayout& message) {
  if (!with_pictures_) with_pictures_.emplace();
  with_pictures_->insert(message.pictures.begin(), message.pictures.end());
}

std::map<std::string, Body> Audit::bodies() const {
  std::map<std::string, Body> bodies = states_;
  // Returns the body of that key, or else the only one whose name matches; or nullptr.
  const auto find = [&bodies](const std::string& key, const auto& matches) -> Body* {
    if (const auto known = bodies.find(key); known != bodies.end()) return &known->second;
    Body* found = nullptr;
    for (auto& entry : bodies) {
      if (!matches(entry.second.name)) continue;
      if (found) return nullptr;
      found = &entry.second;
    }
    return found;
  };
  for (const auto& [key, descriptions] : descriptions_) {
    const std::string& name = descriptions.front().body;
    Body* body = find(key, [&](const std::string& known) { return known == name; });
    if (!body) {
      body = &bodies[key];
      body->key = key;
      body->name = name;
    }
    body->descriptions.insert(body->descriptions.end(), descriptions.begin(), descriptions.end());
  }
  for (const auto& [key, odometry] : odometry_) {
    const std::string& frame = odometry.by_stamp.begin()->second.child_frame_id;
    Body* body = find(key, [&](const std::string& known) { return endsWith(frame, known); });
    if (!body) continue;  // somebody else's robot
    body->odometry.by_stamp.insert(odometry.by_stamp.begin(), odometry.by_stamp.end());
    body->odometry.backwards += odometry.backwards;
  }
  for (const auto& [name_space, drawings] : drawings_) {
    for (const Drawing& drawing : drawings) {
      const std::string name = drawing.name_space.substr(0, drawing.name_space.find('/'));
      Body* body = find(name_space + "/" + name, [&](const std::string& known) { return known == name; });
      if (body) body->drawings.push_back(drawing);
    }
  }
  for (auto& entry : bodies) {
    entry.second.frame = frameOf(entry.second);
    entry.second.putInOrder();
  }
  return bodies;
}

std::string Audit::frameOf(const Body& body) const {
  if (!body.odometry.by_stamp.empty()) return body.odometry.by_stamp.rbegin()->second.child_frame_id;
  std::string best;
  std::int64_t best_score = -1;
  for (const auto& [frame, track] : transforms_.moving()) {
    if (!endsWith(frame, body.name)) continue;
    // Of frames of several nodes, choose the one that turns as this body does, or else has its states' stamps.
    std::int64_t score = 0;
    for (const State& state : body.states) {
      const Transform* found = track.at(state.stamp, state.attitude);
      if (found) score += angleBetween(found->attitude, state.attitude) < 1e-9 ? 1000 : 1;
    }
    if (score > best_score) {
      best_score = score;
      best = frame;
    }
  }
  return best;
}

Report Audit::report() const {
  Report report;
  for (const auto& entry : bodies()) {
    const Body& body = entry.second;
    const std::vector<Segment> segments = body.descriptions.empty() ? std::vector<Segment>() : segmentsOf(body);
    const Evidence evidence{body, segments, transforms_, options_};
    if (body.states.empty()) {
      Judge judge("states", body.key);
      judge.ifNothing("no state of this body was received, only its description");
      report.checks.push_back(judge.verdict());
      continue;
    }
    judgeForm(evidence, report.checks);
    judgeAgreement(evidence, report.checks);
    judgeDescription(evidence, report.checks);
    // Without inertia, motion and energy cannot be judged; judgeDescription has reported that.
    if (body.descriptions.empty()) continue;
    judgeState(evidence, report.checks);
    judgeMotion(evidence, report.checks);
    judgeConservation(evidence, report.checks);
    if (!options_.markers) continue;
    if (!with_pictures_ || with_pictures_->count(body.name) > 0) {
      judgeMarkers(evidence, report.checks);
    } else {
      judgeNoPictures(body, report.checks);
    }
  }
  return report;
}

}  // namespace poinsot::audit
