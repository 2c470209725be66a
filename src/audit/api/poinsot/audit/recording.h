#pragma once

#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <poinsot/BodyDescription.h>
#include <poinsot/BodyState.h>
#include <ros/time.h>
#include <visualization_msgs/Marker.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/audit/effects.h"

/** The messages received, as plain data. Quaternions are held as sent (`…_as_sent`) and normalised. */
namespace poinsot::audit {

using Stamp = std::int64_t;  ///< ROS time [ns]

inline Stamp stampOf(const ros::Time& t) {
  return static_cast<Stamp>(t.sec) * 1000000000 + t.nsec;
}
inline double seconds(Stamp stamp) {
  return 1e-9 * static_cast<double>(stamp);
}

/** Returns a geometry_msgs/Point or Vector3 as a vector. */
template <class Xyz>
Eigen::Vector3d vectorOf(const Xyz& v) {
  return {v.x, v.y, v.z};
}
inline Eigen::Quaterniond quaternionOf(const geometry_msgs::Quaternion& q) {
  return {q.w, q.x, q.y, q.z};
}

/** Returns the name of a frame without a leading slash. */
std::string frameName(const std::string& name);

bool endsWith(const std::string& text, const std::string& tail);

/** Returns the angle of the rotation from a to b [rad], in [0, π]; both unit. Accurate for small angles too. */
double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

/** What states, odometry and transforms have in common. */
struct Pose {
  std::string frame_id;                           ///< in which it is given
  Eigen::Quaterniond attitude_as_sent, attitude;  ///< the second normalised
  Eigen::Vector3d position;
  std::string flaw;  ///< a field that is not finite, or a zero quaternion; empty where the message can be used
};
using Transform = Pose;

/** A state; the names are those of the message. */
struct State : Pose {
  Stamp stamp = 0;
  std::uint32_t sequence = 0;  ///< as its publisher counts; 0 where it does not
  double time = 0, time_rate = 0;
  std::uint32_t segment = 0;
  Eigen::Vector3d velocity, omega_body, omega_world, momentum_world;
  double kinetic_energy = 0, energy_drift = 0, momentum_drift = 0;
  double attitude_error = 0;  ///< [rad]; NaN where there is no closed form
};

struct Odometry : Pose {
  Eigen::Vector3d linear, angular;
  std::string child_frame_id;
};

/** Returns how far the nearest of some stamps lies from one [s], negative where it is earlier. */
template <class Keyed>
double toNearest(const Keyed& by_stamp, Stamp stamp) {
  double best = std::numeric_limits<double>::infinity();
  const auto after = by_stamp.lower_bound(stamp);
  if (after != by_stamp.end()) best = seconds(after->first - stamp);
  if (after == by_stamp.begin()) return best;
  const double before = seconds(std::prev(after)->first - stamp);
  return std::abs(before) < std::abs(best) ? before : best;
}

/** The messages of a topic, or of a tf frame. A stamp comes again where the clock jumps back or stands still. */
template <class Message>
struct Track {
  std::multimap<Stamp, Message> by_stamp;
  Stamp last = 0;
  std::int64_t backwards = 0;  ///< how often a stamp lay before the previous one

  void add(Stamp stamp, Message message) {
    if (!by_stamp.empty() && stamp < last) ++backwards;
    last = stamp;
    by_stamp.emplace(stamp, std::move(message));
  }

  /** Returns, of the messages with a stamp, the one with the nearest attitude; nullptr where there is none. */
  const Message* at(Stamp stamp, const Eigen::Quaterniond& attitude) const {
    const auto [begin, end] = by_stamp.equal_range(stamp);
    const auto best = std::min_element(begin, end, [&](const auto& a, const auto& b) {
      return angleBetween(a.second.attitude, attitude) < angleBetween(b.second.attitude, attitude);
    });
    return best == end ? nullptr : &best->second;
  }
};

struct Description {
  Stamp stamp = 0;
  std::string body;
  Eigen::Matrix3d tensor;  ///< M, body axes
  Eigen::Vector3d moments;
  Eigen::Quaterniond axes;
  std::string method;
  double step = 0, accuracy = 0;     ///< NaN where there is none
  std::vector<std::string> effects;  ///< as sent
  Effects forces;                    ///< the same, as read
  double metres_per_radian_per_second = 0;

  /** Returns whether nothing turns the body: it has no effect but translation. */
  bool isFree() const { return !forces.turns; }
};

/** A marker, as far as checks need it. */
struct Drawing {
  Stamp stamp = 0;  ///< 0: does not change
  std::string name_space, frame_id;
  int type = 0;
  Eigen::Vector3d position, scale;
  Eigen::Quaterniond orientation_as_sent, orientation;
  std::vector<Eigen::Vector3d> points;  ///< of polhodes and arrows only
  std::string flaw;
};

State read(const poinsot::BodyState& message);
Odometry read(const nav_msgs::Odometry& message);
Transform read(const geometry_msgs::TransformStamped& message);
Description read(const poinsot::BodyDescription& message);
Drawing read(const visualization_msgs::Marker& message);

/** The messages about one body. */
struct Body {
  std::string key;            ///< its topics' namespace
  std::string name;           ///< as its messages say
  std::vector<State> states;  ///< as received, until they are put in order
  bool repeats = false;       ///< whether some came again, as when a recording is played in a loop; those are left out
  bool listed = false;        ///< whether they were received in another order than that in which they were sent
  std::int64_t jumps = 0;     ///< how often their clock jumped back, as far as they show
  Track<Odometry> odometry;
  std::vector<Description> descriptions;
  std::vector<Drawing> drawings;  ///< the markers whose namespace begins with its name

  std::string frame;  ///< its tf frame, empty where unknown

  /** Returns the description in force at a stamp, or nullptr. */
  const Description* descriptionAt(Stamp stamp) const;
  /** Returns whether all torques of all descriptions could be read, so that the rotation is known. */
  bool torquesAreRead() const;
  /** Returns whether the translations of all descriptions could be read. */
  bool translationIsRead() const;
  /** Returns whether it is free by all descriptions. */
  bool isFree() const;

  /**
   * Puts the states in the order in which they were sent. A bag that was recorded by a clock that jumped back lists
   * them by stamp, those of one time that the clock ran between those of another.
   */
  void putInOrder();
};

/** All transforms, by the frame that they place. */
class Transforms {
 public:
  void add(const std::string& child, Stamp stamp, const Transform& transform, bool is_static);

  /** Returns the transforms of one frame that moves, or nullptr. */
  const Track<Transform>* moving(const std::string& child) const;
  const std::map<std::string, Track<Transform>>& moving() const { return moving_; }

  /**
   * Returns the pose with v_to = pose * v_from at exactly that stamp; nothing where no received transforms join the
   * frames.
   * @param near of several transforms at that stamp, the one nearest to this attitude counts.
   */
  std::optional<Eigen::Isometry3d> between(const std::string& from, const std::string& to, Stamp stamp,
                                           const Eigen::Quaterniond& near = Eigen::Quaterniond::Identity()) const;

 private:
  std::vector<std::pair<std::string, Eigen::Isometry3d>> chainToRoot(const std::string& frame, Stamp stamp,
                                                                     const Eigen::Quaterniond& near) const;

  std::map<std::string, Track<Transform>> moving_;
  std::map<std::string, Transform> fixed_;
};

}  // namespace poinsot::audit
