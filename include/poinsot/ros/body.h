#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <optional>
#include <string>
#include <vector>

#include "poinsot/BodyDescription.h"
#include "poinsot/core/motion.h"
#include "poinsot/ros/body_picture.h"
#include "poinsot/ros/cost_meter.h"
#include "poinsot/ros/names.h"
#include "poinsot/ros/simulation_clock.h"
#include "poinsot/scene/scene.h"

namespace poinsot::node {

/** One body of the scene on the ROS graph: its motion, its publishers, its frames. */
class Body {
 public:
  /** @param rate of the ticks [Hz]. */
  Body(const scene::Body& body, const std::string& frame_prefix, double rate, const ros::NodeHandle& handle);

  const std::string& name() const { return name_; }
  Motion& motion() { return motion_; }
  const Motion& motion() const { return motion_; }
  BodyPicture& picture() { return picture_; }
  const BodyPicture& picture() const { return picture_; }
  const CostMeter& cost() const { return cost_; }
  /** Of the last move. */
  BodyPicture::Figures figures() const { return {motion_.attitudeError(state_), energy_drift_, cost_.cost()}; }
  double momentumDrift() const { return momentum_drift_; }

  /** Takes a motion that was moved ahead elsewhere. */
  void replaceMotion(Motion&& motion) { motion_ = std::move(motion); }

  /** Moves to the tick's time. Throws std::runtime_error where the motion has no state there that doubles can hold. */
  const MotionState& move(const Tick& tick);

  void appendTransforms(const ros::Time& stamp, std::vector<geometry_msgs::TransformStamped>& out) const;
  void appendStaticTransforms(const ros::Time& stamp, std::vector<geometry_msgs::TransformStamped>& out) const;

  /** Publishes state and odometry of the last move to whoever listens. */
  void publish(const Tick& tick);
  void publishDescription();
  const MotionState& state() const { return state_; }

 private:
  BodyDescription description() const;

  std::string name_;
  names::Frames frames_;
  Motion motion_;
  double accuracy_;  ///< asked for [rad], NaN where none was
  BodyPicture picture_;
  MotionState state_;
  std::optional<std::uint32_t> segment_;
  Invariants segment_start_;
  double energy_drift_ = 0;
  double momentum_drift_ = 0;
  CostMeter cost_;
  ros::Publisher state_publisher_, odometry_publisher_, description_publisher_;
};

}  // namespace poinsot::node
