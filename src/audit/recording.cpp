#include "poinsot/audit/recording.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace poinsot::audit {
namespace {

/** Converts fields, and remembers the first that cannot be used. */
class Fields {
 public:
  explicit Fields(std::string& flaw) : flaw_(flaw) {}

  double number(double value, const char* name) {
    if (!std::isfinite(value)) found(name, " is not finite");
    return value;
  }
  template <class Xyz>
  Eigen::Vector3d vector(const Xyz& value, const char* name) {
    const Eigen::Vector3d out = vectorOf(value);
    if (!out.allFinite()) found(name, " is not finite");
    return out;
  }
  /** Returns it normalised; the identity where that is impossible. */
  Eigen::Quaterniond quaternion(const geometry_msgs::Quaternion& value, const char* name, Eigen::Quaterniond& as_sent) {
    as_sent = quaternionOf(value);
    if (as_sent.coeffs().allFinite() && !(as_sent.norm() < 1e-6)) return as_sent.normalized();
    found(name, as_sent.coeffs().allFinite() ? " is zero, which is no rotation" : " is not finite");
    return Eigen::Quaterniond::Identity();
  }

 private:
  void found(const char* name, const char* what) {
    if (flaw_.empty()) flaw_ = std::string(name) + what;
  }
  std::string& flaw_;
};

}  // namespace

std::string frameName(const std::string& name) {
  return !name.empty() && name[0] == '/' ? name.substr(1) : name;
}

bool endsWith(const std::string& text, const std::string& tail) {
  return text.size() >= tail.size() && text.compare(text.size() - tail.size(), tail.size(), tail) == 0;
}

double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Eigen::Quaterniond d = a.conjugate() * b;
  return 2 * std::atan2(d.vec().norm(), std::abs(d.w()));
}

State read(const poinsot::BodyState& message) {
  State s;
  s.stamp = stampOf(message.header.stamp);
  s.sequence = message.header.seq;
  s.frame_id = frameName(message.header.frame_id);
  s.segment = message.segment;
  Fields fields(s.flaw);
  s.time = fields.number(message.time, "time");
  s.time_rate = fields.number(message.time_rate, "time_rate");
  s.attitude = fields.quaternion(message.attitude, "attitude", s.attitude_as_sent);
  s.position = fields.vector(message.position, "position");
  s.velocity = fields.vector(message.velocity, "velocity");
  s.omega_body = fields.vector(message.omega_body, "omega_body");
  s.omega_world = fields.vector(message.omega_world, "omega_world");
  s.momentum_world = fields.vector(message.momentum_world, "momentum_world");
  s.kinetic_energy = fields.number(message.kinetic_energy, "kinetic_energy");
  s.energy_drift = message.energy_drift;
  s.momentum_drift = message.momentum_drift;
  s.attitude_error = message.attitude_error;
  // Relative drifts of a body that started at rest are rightly infinite, but never NaN.
  if (std::isnan(s.energy_drift)) fields.number(s.energy_drift, "energy_drift");
  if (std::isnan(s.momentum_drift)) fields.number(s.momentum_drift, "momentum_drift");
  // NaN stands for a cost that was not measured.
  if (!std::isnan(message.cost)) fields.number(message.cost, "cost");
  return s;
}

Odometry read(const nav_msgs::Odometry& message) {
  Odometry o;
  o.frame_id = frameName(message.header.frame_id);
  o.child_frame_id = frameName(message.child_frame_id);
  Fields fields(o.flaw);
  o.attitude = fields.quaternion(message.pose.pose.orientation, "pose.orientation", o.attitude_as_sent);
  o.position = fields.vector(message.pose.pose.position, "pose.position");
  o.linear = fields.vector(message.twist.twist.linear, "twist.linear");
  o.angular = fields.vector(message.twist.twist.angular, "twist.angular");
  return o;
}

Transform read(const geometry_msgs::TransformStamped& message) {
  Transform t;
  t.frame_id = frameName(message.header.frame_id);
  Fields fields(t.flaw);
  t.attitude = fields.quaternion(message.transform.rotation, "rotation", t.attitude_as_sent);
  t.position = fields.vector(message.transform.translation, "translation");
  return t;
}

Description read(const poinsot::BodyDescription& message) {
  Description d;
  d.stamp = stampOf(message.header.stamp);
  d.body = message.body;
  for (int i = 0; i < 9; ++i) d.tensor(i / 3, i % 3) = message.inertia_tensor[i];
  for (int i = 0; i < 3; ++i) d.moments[i] = message.principal_moments[i];
  d.axes = quaternionOf(message.principal_axes);
  d.method = message.method;
  d.step = message.step;
  d.accuracy = message.accuracy;
  d.effects = message.effects;
  d.forces = readEffects(d.effects);
  d.metres_per_radian_per_second = message.metres_per_radian_per_second;
  return d;
}

Drawing read(const visualization_msgs::Marker& message) {
  Drawing d;
  d.stamp = stampOf(message.header.stamp);
  d.frame_id = frameName(message.header.frame_id);
  d.name_space = message.ns;
  d.type = message.type;
  Fields fields(d.flaw);
  d.position = fields.vector(message.pose.position, "pose.position");
  d.scale = fields.vector(message.scale, "scale");
  d.orientation = fields.quaternion(message.pose.orientation, "pose.orientation", d.orientation_as_sent);
  const bool keep = endsWith(message.ns, "/polhode") || endsWith(message.ns, "/omega");
  for (const geometry_msgs::Point& point : message.points) {
    const Eigen::Vector3d p = fields.vector(point, "a point");
    if (keep) d.points.push_back(p);
  }
  return d;
}

bool Body::isFree() const {
  return std::all_of(descriptions.begin(), descriptions.end(), [](const Description& d) { return d.isFree(); });
}

bool Body::torquesAreRead() const {
  return std::all_of(descriptions.begin(), descriptions.end(),
                     [](const Description& d) { return d.forces.torques_are_read; });
}

bool Body::translationIsRead() const {
  return std::all_of(descriptions.begin(), descriptions.end(),
                     [](const Description& d) { return d.forces.translation_is_read; });
}

void Body::putInOrder() {
  // Messages between which `time` goes on as time_rate says were sent one after the other, in whatever segments.
  bool disorder = false, goes_on = false;
  std::set<std::uint32_t> sequence;
  for (std::size_t i = 0; i < states.size(); ++i) {
    sequence.insert(states[i].sequence);
    if (i == 0) continue;
    const State &a = states[i - 1], &b = states[i];
    disorder = disorder || (repeats && b.segment == a.segment && b.stamp < a.stamp);
    if (b.segment >= a.segment) continue;
    disorder = true;
    goes_on = goes_on || std::abs(b.time - a.time - a.time_rate * seconds(b.stamp - a.stamp)) < 1e-8;
  }
  if (disorder && sequence.size() == states.size()) {
    listed = true;
    std::sort(states.begin(), states.end(), [](const State& a, const State& b) { return a.sequence < b.sequence; });
  } else if (disorder && !goes_on) {
    listed = true;
    std::stable_sort(states.begin(), states.end(),
                     [](const State& a, const State& b) { return a.segment < b.segment; });
  }
  for (std::size_t i = 1; i < states.size(); ++i) {
    jumps += states[i].stamp < states[i - 1].stamp && states[i].segment > states[i - 1].segment;
  }
}

const Description* Body::descriptionAt(Stamp stamp) const {
  const Description* found = nullptr;
  for (const Description& d : descriptions) {
    if (d.stamp <= stamp) found = &d;
  }
  return found ? found : descriptions.empty() ? nullptr : &descriptions.front();
}

void Transforms::add(const std::string& child, Stamp stamp, const Transform& transform, bool is_static) {
  if (is_static) {
    fixed_[child] = transform;
  } else {
    moving_[child].add(stamp, transform);
  }
}

const Track<Transform>* Transforms::moving(const std::string& child) const {
  const auto found = moving_.find(child);
  return found == moving_.end() ? nullptr : &found->second;
}

std::vector<std::pair<std::string, Eigen::Isometry3d>> Transforms::chainToRoot(const std::string& frame, Stamp stamp,
                                                                               const Eigen::Quaterniond& near) const {
  std::vector<std::pair<std::string, Eigen::Isometry3d>> chain{{frame, Eigen::Isometry3d::Identity()}};
  // Ends where frames form a loop: no tree of ours is 64 deep.
  while (chain.size() < 64) {
    const auto still = fixed_.find(chain.back().first);
    const Transform* step = still == fixed_.end() ? nullptr : &still->second;
    if (!step) {
      const Track<Transform>* moving = this->moving(chain.back().first);
      step = moving ? moving->at(stamp, near) : nullptr;
      if (!step) break;
    }
    if (!step->flaw.empty()) break;
    const Eigen::Isometry3d up = Eigen::Translation3d(step->position) * step->attitude * chain.back().second;
    chain.emplace_back(step->frame_id, up);
  }
  return chain;
}

std::optional<Eigen::Isometry3d> Transforms::between(const std::string& from, const std::string& to, Stamp stamp,
                                                     const Eigen::Quaterniond& near) const {
  if (from == to) return Eigen::Isometry3d::Identity();
  // Up from both frames to the first in common: transforms above it would only add rounding.
  const auto up = chainToRoot(from, stamp, near), down = chainToRoot(to, stamp, near);
  for (const auto& a : up) {
    for (const auto& b : down) {
      if (a.first == b.first) return b.second.inverse(Eigen::Isometry) * a.second;
    }
  }
  return std::nullopt;
}

}  // namespace poinsot::audit
