#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Vector3.h>
#include <nav_msgs/Odometry.h>
#include <poinsot/BodyDescription.h>
#include <poinsot/BodyState.h>
#include <ros/time.h>
#include <visualization_msgs/Marker.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "poinsot/audit/effects.h"

/** What was received, as plain data. A quaternion `…_as_sent` comes with its normalised self. */
namespace poinsot::audit {

using Stamp = std::int64_t;  ///< ROS time [ns]

inline Stamp stampOf(const ros::Time& t) {
  return static_cast<Stamp>(t.sec) * 1000000000 + t.nsec;
}
inline double seconds(Stamp stamp) {
  return 1e-9 * static_cast<double>(stamp);
}

inline Eigen::Vector3d vectorOf(const geometry_msgs::Point& v) {
  return {v.x, v.y, v.z};
}
inline Eigen::Vector3d vectorOf(const geometry_msgs::Vector3& v) {
  return {v.x, v.y, v.z};
}
inline Eigen::Quaterniond quaternionOf(const geometry_msgs::Quaternion& q) {
  return {q.w, q.x, q.y, q.z};
}

/** The angle of the rotation that takes a to b [rad], in [0, π]; both unit, either sign. Accurate for small angles. */
double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

/** A state, in the vocabulary of the message. */
struct State {
  Stamp stamp = 0;
  double time = 0, time_rate = 0;
  std::uint32_t segment = 0;
  Eigen::Quaterniond attitude_as_sent, attitude;  ///< the second normalised
  Eigen::Vector3d position, velocity, omega_body, omega_world, momentum_world;
  double kinetic_energy = 0, energy_drift = 0, momentum_drift = 0;
  double attitude_error = 0;  ///< NaN: there is nothing to compare with
  std::string frame_id;
  std::string flaw;  ///< which field is not finite (or a zero quaternion); empty where the message can be used
};

struct Odometry {
  Eigen::Quaterniond attitude_as_sent, attitude;
  Eigen::Vector3d position, linear, angular;
  std::string frame_id, child_frame_id;
  std::string flaw;
};

struct Transform {
  std::string parent;
  Eigen::Quaterniond rotation_as_sent, rotation;
  Eigen::Vector3d translation;
  std::string flaw;
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

  bool hasEffect(const std::string& type) const;
  /** True when nothing turns the body: no effect, or none but translation. */
  bool isFree() const;
};

/** A marker, without what no check looks at. */
struct Drawing {
  Stamp stamp = 0;  ///< 0: does not change
  std::string name_space, frame_id;
  int id = 0, type = 0;
  Eigen::Vector3d position, scale;
  Eigen::Quaterniond orientation_as_sent, orientation;
  std::vector<Eigen::Vector3d> points;  ///< of polhodes and arrows only
  std::string flaw;

  bool sameAs(const Drawing& other) const;
};

State read(const poinsot::BodyState& message);
Odometry read(const nav_msgs::Odometry& message);
Transform read(const geometry_msgs::TransformStamped& message);
Description read(const poinsot::BodyDescription& message);
Drawing read(const visualization_msgs::Marker& message);

/** What one body's topics carried. A stamp may come more than once (a seek on a clock that stands still). */
struct Body {
  std::string key;   ///< its topics' namespace
  std::string name;  ///< as its messages say
  std::vector<State> states;
  std::multimap<Stamp, Odometry> odometry;
  std::int64_t odometry_backwards = 0;
  std::vector<Description> descriptions;
  std::vector<Drawing> drawings;  ///< the markers whose namespace begins with its name

  std::string frame;  ///< its tf frame, empty where unknown

  /** The description in force at a stamp, or nullptr. */
  const Description* descriptionAt(Stamp stamp) const;
  /** All texts of all descriptions could be read. */
  bool effectsAreRead() const;
};

/** All transforms, by the frame that they place. */
class Transforms {
 public:
  void add(const std::string& child, Stamp stamp, const Transform& transform, bool is_static);

  /** Those of one frame that moves, by stamp. */
  const std::multimap<Stamp, Transform>* moving(const std::string& child) const;
  std::int64_t backwards(const std::string& child) const;
  std::vector<std::string> movingFrames() const;
  const Transform* fixed(const std::string& child) const;

  /** v_to = pose * v_from at exactly that stamp; nothing where the frames are not joined by what was received. */
  std::optional<Eigen::Isometry3d> between(const std::string& from, const std::string& to, Stamp stamp) const;

 private:
  std::vector<std::pair<std::string, Eigen::Isometry3d>> chainToRoot(const std::string& frame, Stamp stamp) const;

  struct Moving {
    std::multimap<Stamp, Transform> by_stamp;
    Stamp last = 0;
    std::int64_t backwards = 0;
  };
  std::map<std::string, Moving> moving_;
  std::map<std::string, Transform> fixed_;
};

}  // namespace poinsot::audit
