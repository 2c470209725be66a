#include "poinsot/ros/body_messages.h"

#include <algorithm>
#include <limits>

#include "poinsot/ros/conversions.h"

namespace poinsot::node {
namespace {

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

void appendTransforms(const session::MovingBody& body, const names::Frames& frames, const ros::Time& stamp,
                      std::vector<geometry_msgs::TransformStamped>& out) {
  const MotionState& state = body.state();
  out.push_back(transform(stamp, names::kWorld, frames.body, state.position, state.attitude));
  out.push_back(transform(stamp, frames.space, frames.space_body, Eigen::Vector3d::Zero(), state.attitude));
}

void appendStaticTransforms(const names::Frames& frames, const view::PictureFrame& frame, const ros::Time& stamp,
                            std::vector<geometry_msgs::TransformStamped>& out) {
  out.push_back(
      transform(stamp, names::kWorld, frames.space, frame.place.space_centre, Eigen::Quaterniond::Identity()));
  out.push_back(transform(stamp, names::kWorld, frames.model, frame.place.model_centre, frame.model_orientation));
}

BodyState stateMessage(const session::MovingBody& body, const session::Tick& tick, double cost) {
  const MotionState& state = body.state();
  BodyState out;
  out.header.stamp = toTime(tick.stamp);
  out.header.frame_id = names::kWorld;
  out.body = body.name();
  out.time = state.time;
  out.time_rate = tick.time_rate;
  out.segment = tick.segment;
  out.attitude = toQuaternion(state.attitude);
  out.position = toPoint(state.position);
  out.velocity = toVector3(state.velocity);
  out.omega_body = toVector3(state.omega_body);
  out.omega_world = toVector3(state.omega_world);
  out.momentum_world = toVector3(state.momentum_world);
  out.kinetic_energy = state.kinetic_energy;
  out.energy_drift = body.energyDrift();
  out.momentum_drift = body.momentumDrift();
  out.attitude_error = body.attitudeError();
  out.cost = cost;
  return out;
}

nav_msgs::Odometry odometryMessage(const session::MovingBody& body, const std::string& frame,
                                   const session::Tick& tick) {
  const MotionState& state = body.state();
  nav_msgs::Odometry out;
  out.header.stamp = toTime(tick.stamp);
  out.header.frame_id = names::kWorld;
  out.child_frame_id = frame;
  out.pose.pose.position = toPoint(state.position);
  out.pose.pose.orientation = toQuaternion(state.attitude);
  out.twist.twist.linear = toVector3(state.attitude.conjugate() * state.velocity);
  out.twist.twist.angular = toVector3(state.omega_body);
  return out;
}

BodyDescription descriptionMessage(const session::MovingBody& body, const std::string& frame_id,
                                   const view::PictureFrame& frame) {
  const MotionSetup& setup = body.motion().setup();
  BodyDescription out;
  out.header.frame_id = frame_id;
  out.body = body.name();
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> tensor = setup.inertia.tensor();
  std::copy(tensor.data(), tensor.data() + 9, out.inertia_tensor.begin());
  std::copy(setup.inertia.moments().data(), setup.inertia.moments().data() + 3, out.principal_moments.begin());
  out.principal_axes = toQuaternion(setup.inertia.axes());
  out.method = setup.method;
  out.step = setup.step.value_or(std::numeric_limits<double>::quiet_NaN());
  out.accuracy = body.accuracy();
  if (setup.translation) out.effects.push_back(std::string(Translation::kName) + ": " + setup.translation->text());
  for (const Effect& effect : setup.effects) out.effects.push_back(textOf(effect));
  const view::PictureScale scale = view::scaleInMetres(frame);
  out.metres_per_radian_per_second = scale.metres_per_radian_per_second;
  out.metres_per_angular_momentum = scale.metres_per_angular_momentum;
  return out;
}

}  // namespace poinsot::node
