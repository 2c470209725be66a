#pragma once

#include <gtest/gtest.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "poinsot/ros/body_messages.h"
#include "poinsot/ros/markers/body_picture.h"
#include "poinsot/session/moving_body.h"

/** What is drawn of one body, in numbers: from its markers and its tf alone. */
namespace poinsot::node {

using Eigen::Vector3d;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

inline Eigen::Quaterniond quaternion(const geometry_msgs::Quaternion& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z);
}
inline Vector3d vector(const geometry_msgs::Point& p) {
  return {p.x, p.y, p.z};
}
inline Vector3d vector(const geometry_msgs::Vector3& v) {
  return {v.x, v.y, v.z};
}

/** Where a marker's point is, in its frame. */
inline Vector3d placed(const Marker& m, std::size_t i) {
  return vector(m.pose.position) + quaternion(m.pose.orientation) * vector(m.points[i]);
}

/** A free body's pictures. Static markers may be spoilt to see that a check notices. */
class Drawn {
 public:
  Drawn(const Vector3d& moments, const Vector3d& omega,
        const Eigen::Quaterniond& attitude = Eigen::Quaterniond(0.8, 0.3, -0.2, 0.4).normalized())
      : Drawn(PrincipalInertia::fromMoments(moments), omega, attitude) {}

  Drawn(const PrincipalInertia& inertia, const Vector3d& omega, const Eigen::Quaterniond& attitude)
      : scene_body_(of(inertia, omega, attitude)),
        body_(scene_body_),
        frames_("", scene_body_.name),
        picture_(scene_body_, body_.motion(), frames_, BodyPicture::Detail::pictures) {
    picture_.appendStatic(still);
  }

  static scene::Body of(const PrincipalInertia& inertia, const Vector3d& omega, const Eigen::Quaterniond& attitude) {
    scene::Body body;
    body.name = "body";
    body.inertia = inertia;
    body.omega_body = omega;
    body.attitude = attitude;
    return body;
  }

  MarkerArray still;

  /** A static marker, by what comes after the body's name. */
  Marker& get(const std::string& what, int id = 0) {
    for (Marker& m : still.markers) {
      if (m.ns == "body/" + what && m.id == id) return m;
    }
    throw std::runtime_error("no marker " + what);
  }
  bool has(const std::string& what) const {
    for (const Marker& m : still.markers) {
      if (m.ns == "body/" + what) return true;
    }
    return false;
  }

  /** Of the static labels the one that begins like that. */
  std::string words(const std::string& beginning) const {
    for (const Marker& m : still.markers) {
      if (m.ns == "body/label" && m.text.rfind(beginning, 0) == 0) return m.text;
    }
    throw std::runtime_error("no words " + beginning);
  }

  /** What moves, at t [s]. */
  MarkerArray at(double t) {
    session::Tick tick;
    tick.stamp = (1000 + stamps_++) * session::kSecond;
    tick.time = t;
    tick.time_rate = 1;
    body_.move(tick);
    MarkerArray out;
    picture_.appendMoving(tick, body_.motion(), body_.state(), out);
    return out;
  }

  /** The tip of the arrow of ω at t, in <body>_space. */
  Vector3d tip(double t) {
    for (const Marker& m : at(t).markers) {
      if (m.ns == "body/space/omega") return placed(m, 1);
    }
    throw std::runtime_error("no arrow of omega");
  }
  /** The bead at t, in <body>_model. */
  Vector3d bead(double t) {
    for (const Marker& m : at(t).markers) {
      if (m.ns == "body/model/omega") return vector(m.pose.position);
    }
    throw std::runtime_error("no bead");
  }

  /** How <body>_space_body lies in <body>_space at t, by tf. */
  Eigen::Quaterniond attitude(double t) {
    at(t);
    std::vector<geometry_msgs::TransformStamped> transforms;
    appendTransforms(body_, frames_, ros::Time(1), transforms);
    for (const auto& transform : transforms) {
      if (transform.child_frame_id == "body_space_body") return quaternion(transform.transform.rotation);
    }
    throw std::runtime_error("no transform");
  }

  /** ω [rad/s] from the attitudes just before and after. */
  Vector3d spin(double t, double h) {
    const Eigen::AngleAxisd turn(attitude(t + h) * attitude(t - h).conjugate());
    const double angle = turn.angle() > M_PI ? turn.angle() - 2 * M_PI : turn.angle();
    return angle / (2 * h) * turn.axis();
  }

 private:
  scene::Body scene_body_;
  session::MovingBody body_;
  names::Frames frames_;
  BodyPicture picture_;
  int stamps_ = 0;
};

inline double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace poinsot::node
