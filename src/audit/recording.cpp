#include "poinsot/audit/recording.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace poinsot::audit {
namespace {

/** Remembers the first field that cannot be used. */
class FlawFinder {
 public:
  explicit FlawFinder(std::string& flaw) : flaw_(flaw) {}

  void number(double value, const char* name) {
    if (!std::isfinite(value)) found(name, " is not finite");
  }
  void vector(const Eigen::Vector3d& value, const char* name) {
    if (!value.allFinite()) found(name, " is not finite");
  }
  /** @return normalised; the identity where that is impossible. */
  Eigen::Quaterniond quaternion(const Eigen::Quaterniond& value, const char* name) {
    if (!value.coeffs().allFinite()) {
      found(name, " is not finite");
    } else if (value.norm() < 1e-6) {
      found(name, " is zero, which is no rotation");
    } else {
      return value.normalized();
    }
    return Eigen::Quaterniond::Identity();
  }

 private:
  void found(const char* name, const char* what) {
    if (flaw_.empty()) flaw_ = std::string(name) + what;
  }
  std::string& flaw_;
};

std::string frameName(const std::string& name) {
  return !name.empty() && name[0] == '/' ? name.substr(1) : name;
}

}  // namespace

double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Eigen::Quaterniond d = a.conjugate() * b;
  return 2 * std::atan2(d.vec().norm(), std::abs(d.w()));
}

State read(const poinsot::BodyState& message) {
  State s;
  s.stamp = stampOf(message.header.stamp);
  s.sequence = message.header.seq;
  s.frame_id = frameName(message.header.frame_id);
  s.time = message.time;
  s.time_rate = message.time_rate;
  s.segment = message.segment;
  s.attitude_as_sent = quaternionOf(message.attitude);
  s.position = vectorOf(message.position);
  s.velocity = vectorOf(message.velocity);
  s.omega_body = vectorOf(message.omega_body);
  s.omega_world = vectorOf(message.omega_world);
  s.momentum_world = vectorOf(message.momentum_world);
  s.kinetic_energy = message.kinetic_energy;
  s.energy_drift = message.energy_drift;
  s.momentum_drift = message.momentum_drift;
  s.attitude_error = message.attitude_error;
  FlawFinder find(s.flaw);
  find.number(s.time, "time");
  find.number(s.time_rate, "time_rate");
  s.attitude = find.quaternion(s.attitude_as_sent, "attitude");
  find.vector(s.position, "position");
  find.vector(s.velocity, "velocity");
  find.vector(s.omega_body, "omega_body");
  find.vector(s.omega_world, "omega_world");
  find.vector(s.momentum_world, "momentum_world");
  find.number(s.kinetic_energy, "kinetic_energy");
  // Drifts are relative: for a body that started at rest, infinite is the honest figure. Not so NaN.
  if (std::isnan(s.energy_drift)) find.number(s.energy_drift, "energy_drift");
  if (std::isnan(s.momentum_drift)) find.number(s.momentum_drift, "momentum_drift");
  // NaN: not measured, in a recording that nobody played.
  if (!std::isnan(message.cost)) find.number(message.cost, "cost");
  return s;
}

Odometry read(const nav_msgs::Odometry& message) {
  Odometry o;
  o.frame_id = frameName(message.header.frame_id);
  o.child_frame_id = frameName(message.child_frame_id);
  o.attitude_as_sent = quaternionOf(message.pose.pose.orientation);
  o.position = vectorOf(message.pose.pose.position);
  o.linear = vectorOf(message.twist.twist.linear);
  o.angular = vectorOf(message.twist.twist.angular);
  FlawFinder find(o.flaw);
  o.attitude = find.quaternion(o.attitude_as_sent, "pose.orientation");
  find.vector(o.position, "pose.position");
  find.vector(o.linear, "twist.linear");
  find.vector(o.angular, "twist.angular");
  return o;
}

Transform read(const geometry_msgs::TransformStamped& message) {
  Transform t;
  t.frame_id = frameName(message.header.frame_id);
  t.attitude_as_sent = quaternionOf(message.transform.rotation);
  t.position = vectorOf(message.transform.translation);
  FlawFinder find(t.flaw);
  t.attitude = find.quaternion(t.attitude_as_sent, "rotation");
  find.vector(t.position, "translation");
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
  d.id = message.id;
  d.type = message.type;
  d.position = vectorOf(message.pose.position);
  d.scale = vectorOf(message.scale);
  d.orientation_as_sent = quaternionOf(message.pose.orientation);
  FlawFinder find(d.flaw);
  find.vector(d.position, "pose.position");
  find.vector(d.scale, "scale");
  d.orientation = find.quaternion(d.orientation_as_sent, "pose.orientation");
  const auto ends = [&message](const char* what) {
    const std::string tail = std::string("/") + what;
    return message.ns.size() > tail.size() &&
           message.ns.compare(message.ns.size() - tail.size(), tail.size(), tail) == 0;
  };
  const bool keep = ends("polhode") || ends("omega");
  if (keep) d.points.reserve(message.points.size());
  for (const geometry_msgs::Point& point : message.points) {
    const Eigen::Vector3d p = vectorOf(point);
    find.vector(p, "a point");
    if (keep) d.points.push_back(p);
  }
  return d;
}

bool Drawing::sameAs(const Drawing& other) const {
  return stamp == other.stamp && name_space == other.name_space && frame_id == other.frame_id && id == other.id &&
         type == other.type && position == other.position && scale == other.scale &&
         orientation_as_sent.coeffs() == other.orientation_as_sent.coeffs() && points == other.points &&
         flaw == other.flaw;
}

bool Body::isFree() const {
  return std::all_of(descriptions.begin(), descriptions.end(), [](const Description& d) { return d.isFree(); });
}

bool Body::effectsAreRead() const {
  return std::all_of(descriptions.begin(), descriptions.end(),
                     [](const Description& d) { return d.forces.problem.empty(); });
}

void Body::putInOrder() {
  // Time that goes on from one message to the next belongs to one motion, whatever their segments say.
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
  if (!disorder) return;
  if (sequence.size() == states.size()) {
    std::sort(states.begin(), states.end(), [](const State& a, const State& b) { return a.sequence < b.sequence; });
  } else if (!goes_on) {
    std::stable_sort(states.begin(), states.end(),
                     [](const State& a, const State& b) { return a.segment < b.segment; });
  }
}

const Description* Body::descriptionAt(Stamp stamp) const {
  const Description* found = nullptr;
  for (const Description& d : descriptions) {
    if (d.stamp <= stamp) found = &d;
  }
  return found ? found : descriptions.empty() ? nullptr : &descriptions.front();
}

}  // namespace poinsot::audit
