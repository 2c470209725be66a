#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <string>

#include "poinsot/ros/cost_meter.h"
#include "poinsot/ros/moving_body.h"

namespace poinsot::node {

/** One body of the scene on the ROS graph: what it costs, and its publishers. */
class Body : public MovingBody {
 public:
  /** @param rate of the ticks [Hz]; keep: see BodyPicture. */
  Body(const scene::Body& body, const std::string& frame_prefix, double rate, const ros::NodeHandle& handle,
       const std::optional<PictureFrame>& keep = std::nullopt);

  const CostMeter& cost() const { return cost_; }
  /** Of the last move. */
  BodyPicture::Figures figures() const {
    return {attitudeError(), energyDrift(), cost_.cost(), state().kinetic_energy};
  }

  /** MovingBody::move, its cost measured. */
  void move(const Tick& tick);

  /** Publishes state and odometry of the last move to whoever listens. */
  void publish(const Tick& tick);
  void publishDescription();

 private:
  CostMeter cost_;
  ros::Publisher state_publisher_, odometry_publisher_, description_publisher_;
};

}  // namespace poinsot::node
