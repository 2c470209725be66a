#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <ros/subscriber.h>
#include <std_msgs/Float64.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <memory>
#include <optional>
#include <vector>

#include "poinsot/ros/body.h"
#include "poinsot/ros/fair_mutex.h"
#include "poinsot/ros/pacer.h"
#include "poinsot/ros/parameters.h"
#include "poinsot/ros/seeker.h"
#include "poinsot/ros/simulation_clock.h"

namespace poinsot::node {

/**
 * The node: at each tick it asks the clock for the time and every body for its state at that time, and publishes.
 *
 * Ticks run in the caller's thread, services and topics in ROS's; one mutex lies between them.
 */
class Node {
 public:
  /** Throws ParameterError for a scene that this machine cannot step in real time. */
  Node(const Parameters& parameters, const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);

  /** Ticks until ROS shuts down. Throws std::runtime_error when a body has no state that can be published. */
  void run();

 private:
  void tick();
  double steppingCost() const;        ///< of all bodies together [CPU s per simulated s]
  double stepsTo(double time) const;  ///< of all bodies together
  void publishStatic();
  visualization_msgs::MarkerArray staticMarkers() const;
  void resendStaticMarkers();
  void publishMarkers(const Tick& tick);
  void takeFinishedSeek();
  void jumpTo(double time);

  bool onPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool onStep(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool onReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void onSpeed(const std_msgs::Float64& message);
  void onSeek(const std_msgs::Float64& message);

  void diagnoseTicks(diagnostic_updater::DiagnosticStatusWrapper& status);

  FairMutex mutex_;
  SimulationClock clock_;
  Pacer pacer_;
  Seeker seeker_;
  double rate_;
  std::vector<std::unique_ptr<Body>> bodies_;
  bool some_body_steps_ = false;  ///< then labels tell how well

  ros::NodeHandle handle_, private_handle_;
  tf2_ros::TransformBroadcaster broadcaster_;
  tf2_ros::StaticTransformBroadcaster static_broadcaster_;
  std::vector<geometry_msgs::TransformStamped> transforms_;  ///< reused from tick to tick
  ros::Publisher clock_publisher_, markers_publisher_, markers_static_publisher_;
  std::optional<ros::SteadyTime> resend_static_at_;  ///< for whoever subscribed last
  bool markers_watched_ = false;
  std::vector<ros::ServiceServer> services_;
  std::vector<ros::Subscriber> subscribers_;
  diagnostic_updater::Updater diagnostics_;
};

}  // namespace poinsot::node
