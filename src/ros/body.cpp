#include "poinsot/ros/body.h"

#include <nav_msgs/Odometry.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "poinsot/BodyState.h"
#include "poinsot/core/invariants.h"
#include "poinsot/cost/cpu_time.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/scene/motion_setup.h"

namespace poinsot::node {
namespace {

constexpr int kQueue = 1000;  // a second's worth at 1 kHz

geometry_msgs::TransformStamped transform(const ros::Time& stamp, const std::string& parent, const std::string& child,
                                          const Eigen::Vector3d& translation, const Eigen::Quaterniond& rotation) {
  geometry_msgs::TransformStamped out;
  out.header.stamp = stamp;
  out.header.frame_id = parent;
  out.child_frame_id = child;
  out.transform = toTransform(translation, rotation);
  return out;
}

}  // namespace

Body::Body(const scene::Body& body, const std::string& frame_prefix, double rate, const ros::NodeHandle& handle)
    : name_(body.name),
      frames_(frame_prefix, body.name),
      motion_(scene::motionSetup(body)),
      accuracy_(body.accuracy ? body.accuracy->error : std::numeric_limits<double>::quiet_NaN()),
      picture_(body, motion_, frames_),
      state_(motion_.at(0)),
      cost_(motion_, rate) {
  ros::NodeHandle h(handle);
  state_publisher_ = h.advertise<BodyState>(names::topic(name_, names::kState), kQueue);
  odometry_publisher_ = h.advertise<nav_msgs::Odometry>(names::topic(name_, names::kOdometry), kQueue);
  description_publisher_ = h.advertise<BodyDescription>(names::topic(name_, names::kDescription), 1, true);
}

const MotionState& Body::move(const Tick& tick) {
  const double before = state_.time;
  const double begin = cost::threadCpuTime();
  try {
    if (tick.time != state_.time) state_ = motion_.at(tick.time);
  } catch (const std::runtime_error& error) {  // range_error, NoConvergence
    std::ostringstream out;
    out << "body " << name_ << " under " << motion_.setup().method << " at t = " << tick.time << " s: " << error.what();
    throw std::runtime_error(out.str());
  }
  const double cpu = cost::threadCpuTime() - begin;
  if (segment_ == tick.segment) {
    cost_.add(cpu, tick.time - before, state_.time, motion_);
  } else {
    segment_ = tick.segment;
    segment_start_ = state_.invariants();
    picture_.clearTrail();
  }
  const Invariants now = state_.invariants();
  energy_drift_ = poinsot::energyDrift(now, segment_start_);
  momentum_drift_ = poinsot::momentumDrift(now, segment_start_);
  return state_;
}

void Body::appendTransforms(const ros::Time& stamp, std::vector<geometry_msgs::TransformStamped>& out) const {
  out.push_back(transform(stamp, names::kWorld, frames_.body, state_.position, state_.attitude));
  out.push_back(transform(stamp, frames_.space, frames_.space_body, Eigen::Vector3d::Zero(), state_.attitude));
}

void Body::appendStaticTransforms(const ros::Time& stamp, std::vector<geometry_msgs::TransformStamped>& out) const {
  const view::Layout& layout = picture_.layout();
  out.push_back(transform(stamp, names::kWorld, frames_.space, layout.space_centre, Eigen::Quaterniond::Identity()));
  out.push_back(transform(stamp, names::kWorld, frames_.model, layout.model_centre, layout.model_orientation));
}

void Body::publish(const Tick& tick) {
  if (state_publisher_.getNumSubscribers() > 0) {
    BodyState out;
    out.header.stamp = tick.stamp;
    out.header.frame_id = names::kWorld;
    out.body = name_;
    out.time = state_.time;
    out.time_rate = tick.time_rate;
    out.segment = tick.segment;
    out.attitude = toQuaternion(state_.attitude);
    out.position = toPoint(state_.position);
    out.velocity = toVector3(state_.velocity);
    out.omega_body = toVector3(state_.omega_body);
    out.omega_world = toVector3(state_.omega_world);
    out.momentum_world = toVector3(state_.momentum_world);
    out.kinetic_energy = state_.kinetic_energy;
    out.energy_drift = energy_drift_;
    out.momentum_drift = momentum_drift_;
    out.attitude_error = motion_.attitudeError(state_);
    out.cost = cost_.cost();
    state_publisher_.publish(out);
  }
  if (odometry_publisher_.getNumSubscribers() > 0) {
    nav_msgs::Odometry out;
    out.header.stamp = tick.stamp;
    out.header.frame_id = names::kWorld;
    out.child_frame_id = frames_.body;
    out.pose.pose.position = toPoint(state_.position);
    out.pose.pose.orientation = toQuaternion(state_.attitude);
    out.twist.twist.linear = toVector3(state_.attitude.conjugate() * state_.velocity);
    out.twist.twist.angular = toVector3(state_.omega_body);
    odometry_publisher_.publish(out);
  }
}

void Body::publishDescription() {
  description_publisher_.publish(description());
}

BodyDescription Body::description() const {
  const MotionSetup& setup = motion_.setup();
  BodyDescription out;
  out.header.frame_id = frames_.body;
  out.body = name_;
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> tensor = setup.inertia.tensor();
  std::copy(tensor.data(), tensor.data() + 9, out.inertia_tensor.begin());
  std::copy(setup.inertia.moments().data(), setup.inertia.moments().data() + 3, out.principal_moments.begin());
  out.principal_axes = toQuaternion(setup.inertia.axes());
  out.method = setup.method;
  out.step = setup.step.value_or(std::numeric_limits<double>::quiet_NaN());
  out.accuracy = accuracy_;
  if (setup.translation) out.effects.push_back(std::string(Translation::kName) + ": " + setup.translation->text());
  for (const Effect& effect : setup.effects) out.effects.push_back(textOf(effect));
  out.metres_per_radian_per_second = picture_.scale().metres_per_radian_per_second;
  out.metres_per_angular_momentum = picture_.scale().metres_per_angular_momentum;
  return out;
}

}  // namespace poinsot::node
