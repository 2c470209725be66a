#include "poinsot/ros/body.h"

#include "poinsot/cost/cpu_time.h"

namespace poinsot::node {
namespace {

constexpr int kQueue = 1000;  // a second's worth at 1 kHz

}  // namespace

Body::Body(const scene::Body& body, const std::string& frame_prefix, double rate, const ros::NodeHandle& handle,
           const std::optional<PictureFrame>& keep)
    : MovingBody(body, frame_prefix, true, keep), cost_(motion(), rate) {
  ros::NodeHandle h(handle);
  state_publisher_ = h.advertise<BodyState>(names::topic(name(), names::kState), kQueue);
  odometry_publisher_ = h.advertise<nav_msgs::Odometry>(names::topic(name(), names::kOdometry), kQueue);
  description_publisher_ = h.advertise<BodyDescription>(names::topic(name(), names::kDescription), 1, true);
}

void Body::move(const Tick& tick) {
  const double before = state().time;
  const double begin = cost::threadCpuTime();
  const bool continues = MovingBody::move(tick);
  const double cpu = cost::threadCpuTime() - begin;
  if (continues) cost_.add(cpu, tick.time - before, state().time, motion());
}

void Body::publish(const Tick& tick) {
  if (state_publisher_.getNumSubscribers() > 0) state_publisher_.publish(stateMessage(tick, cost_.cost()));
  if (odometry_publisher_.getNumSubscribers() > 0) odometry_publisher_.publish(odometryMessage(tick));
}

void Body::publishDescription() {
  description_publisher_.publish(description());
}

}  // namespace poinsot::node
