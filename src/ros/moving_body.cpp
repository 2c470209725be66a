#include "poinsot/ros/moving_body.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "poinsot/core/invariants.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/scene/motion_setup.h"

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

MovingBody::MovingBody(const scene::Body& body, const std::string& frame_prefix, bool markers,
                       const std::optional<PictureFrame>& keep)
    : name_(body.name),
      frames_(frame_prefix, body.name),
      motion_(scene::motionSetup(body)),
      accuracy_(body.accuracy && !body.accuracy->by_default ? body.accuracy->error
                                                            : std::numeric_limits<double>::quiet_NaN()),
      picture_(std::make_unique<BodyPicture>(
          body, motion_, frames_, markers ? BodyPicture::Detail::pictures : BodyPicture::Detail::none, keep)),
      layout_(picture_->layout()),
      scale_(picture_->scale()),
      state_(motion_.at(0)) {
  if (!markers) picture_.reset();
}

bool MovingBody::move(const Tick& tick) {
  try {
    if (tick.time != state_.time) state_ = motion_.at(tick.time);
  } catch (const std::runtime_error& error) {  // range_error, NoConvergence
    std::ostringstream out;
    out << "body " << name_ << " under " << motion_.setup().method << " at t = " << tick.time << " s: " << error.what();
    throw std::runtime_error(out.str());
  }
  const Invariants now = state_.invariants();
  const bool continues = segment_ == tick.segment;
  if (!continues) {
    segment_ = tick.segment;
    segment_start_ = now;
    if (picture_) picture_->clearTrail();
  }
  energy_drift_ = poinsot::energyDrift(now, segment_start_);
  momentum_drift_ = poinsot::momentumDrift(now, segment_start_);
  return continues;
}

void MovingBody::appendTransforms(const ros::Time& stamp, std::vector<geometry_msgs::TransformStamped>& out) const {
  out.push_back(transform(stamp, names::kWorld, frames_.body, state_.position, state_.attitude));
  out.push_back(transform(stamp, frames_.space, frames_.space_body, Eigen::Vector3d::Zero(), state_.attitude));
}

void MovingBody::appendStaticTransforms(const ros::Time& stamp,
                                        std::vector<geometry_msgs::TransformStamped>& out) const {
  out.push_back(transform(stamp, names::kWorld, frames_.space, layout_.space_centre, Eigen::Quaterniond::Identity()));
  out.push_back(transform(stamp, names::kWorld, frames_.model, layout_.model_centre, layout_.model_orientation));
}

BodyState MovingBody::stateMessage(const Tick& tick, double cost) const {
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
  out.attitude_error = attitudeError();
  out.cost = cost;
  return out;
}

nav_msgs::Odometry MovingBody::odometryMessage(const Tick& tick) const {
  nav_msgs::Odometry out;
  out.header.stamp = tick.stamp;
  out.header.frame_id = names::kWorld;
  out.child_frame_id = frames_.body;
  out.pose.pose.position = toPoint(state_.position);
  out.pose.pose.orientation = toQuaternion(state_.attitude);
  out.twist.twist.linear = toVector3(state_.attitude.conjugate() * state_.velocity);
  out.twist.twist.angular = toVector3(state_.omega_body);
  return out;
}

BodyDescription MovingBody::description() const {
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
  out.metres_per_radian_per_second = scale_.metres_per_radian_per_second;
  out.metres_per_angular_momentum = scale_.metres_per_angular_momentum;
  return out;
}

}  // namespace poinsot::node
