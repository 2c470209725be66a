#pragma once

#include <functional>
#include <string>
#include <vector>

#include "poinsot/audit/audit.h"

/** Synthetic recordings of a node, made without any code of the project but its messages. */
namespace poinsot::test {

struct Moment {
  Eigen::Quaterniond attitude;
  Eigen::Vector3d omega_body;
  Eigen::Vector3d slug_omega = Eigen::Vector3d::Zero();
};

/** A motion: the state at a simulation time. */
using Truth = std::function<Moment(double)>;

/** moments (a, a, c), exactly: ω = L/a + (1 − c/a)Ω₃e₃. */
Truth symmetricTop(double a, double c, const Eigen::Quaterniond& attitude, const Eigen::Vector3d& omega_body);

/** Any tensor, by Runge–Kutta steps of at most `step`, without or with a torque (world axes). */
Truth anyBody(const Eigen::Matrix3d& tensor, const Eigen::Quaterniond& attitude, const Eigen::Vector3d& omega_body,
              double step = 1e-4, const Eigen::Vector3d& torque_world = Eigen::Vector3d::Zero());

/** The torque on a body from outside, body axes [N·m]; and a slug inside, of inertia J and damping c. */
struct Driven {
  std::function<Eigen::Vector3d(double, const Moment&)> torque = [](double, const Moment&) {
    return Eigen::Vector3d(0, 0, 0);
  };
  double slug_inertia = 0, slug_damping = 0;
  std::vector<double> switches;  ///< times at which a torque sets in or ends; steps end there
  bool slug_at_rest = false;     ///< whether it starts with σ = 0, not Ω
  bool slug_turned = true;       ///< whether the term Ω×σ is there
};

/** The same with torques; forwards. */
Truth drivenBody(const Eigen::Matrix3d& tensor, const Eigen::Quaterniond& attitude, const Eigen::Vector3d& omega_body,
                 const Driven& driven, double step = 1e-4);

/** First order on conserved L, with its large drift of E. Forwards only, on the grid n·step. */
Truth lieEuler(const Eigen::Vector3d& moments, const Eigen::Quaterniond& attitude, const Eigen::Vector3d& omega_body,
               double step);

struct Tick {
  std::int64_t stamp;  // ns
  double time, time_rate;
  std::uint32_t segment;
};

/** 60 Hz, rate 1, one segment. */
std::vector<Tick> steadily(int count, double start = 0);

struct BodySetup {
  std::string ns = "/", body = "wingnut", prefix;
  Eigen::Vector3d moments{1, 2, 3};
  Eigen::Quaterniond axes = Eigen::Quaterniond::Identity();
  std::string method = "rk4";
  double step = 1e-4, scale = 0.5, attitude_error = 0;
  std::vector<std::string> effects;
  double slug_inertia = 0;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), acceleration = Eigen::Vector3d::Zero();

  Eigen::Matrix3d tensor() const;
};

/** All messages of one body, which tests spoil one at a time. */
struct Stream {
  BodySetup setup;
  BodyDescription description;
  std::vector<BodyState> states;
  std::vector<nav_msgs::Odometry> odometry;
  std::vector<tf2_msgs::TFMessage> tf;  // [0]: the body, [1]: space_body
  tf2_msgs::TFMessage tf_static;
  std::vector<visualization_msgs::MarkerArray>
      markers;  // [0]: space/omega, [1]: model/omega; under torques the ellipsoids
  visualization_msgs::MarkerArray markers_static;

  Stream(const BodySetup& setup, const Truth& truth, const std::vector<Tick>& ticks);

  /** Returns whether an effect turns the body, so that its ellipsoids change. */
  bool driven() const;
  visualization_msgs::Marker& drawn(const std::string& what);
  void feed(audit::Audit& audit) const;
  audit::Report judged(const audit::Options& options = {}) const;
};

}  // namespace poinsot::test
