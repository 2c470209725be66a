#pragma once

#include <geometry_msgs/PointStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <ros/time.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/ros/body_topics.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/diagnostics.h"
#include "poinsot/ros/parameters.h"
#include "poinsot/ros/scene_topics.h"
#include "poinsot/ros/services.h"
#include "poinsot/ros/spin_handles.h"
#include "poinsot/ros/tick_timer.h"
#include "poinsot/session/session.h"
#include "poinsot/session/thread_job.h"

namespace poinsot::node {

/**
 * The node: turns a session into topics and services.
 *
 * One thread ticks and runs ROS's callbacks between two ticks. Services have a thread of their own, which only posts
 * and waits; what takes long is done by the session's job.
 */
class Node : private session::Listener {
 public:
  /**
   * @param interrupted ends the constructor and run() early.
   * Throws scene::Error for an accuracy that is out of reach; ParameterError for a scene that this machine cannot step
   * in real time; cost::Cancelled.
   */
  Node(const Parameters& parameters, const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
       const std::atomic<bool>& interrupted);
  ~Node() override;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  /**
   * Ticks until ROS shuts down or somebody interrupts. Throws std::runtime_error when a body has no state that can be
   * published.
   */
  void run();

 private:
  void tick(session::Nanoseconds now);
  /** Does what is to be done also while no tick comes. */
  void serve();
  void onSpeed(const std_msgs::Float64& message) { session_->ask(session::SetSpeed{message.data}); }
  void onSeek(const std_msgs::Float64& message) { session_->ask(session::Seek{message.data}); }
  void onViewpoint(const geometry_msgs::PointStamped& message);
  void onLightBackground(const std_msgs::Bool& message) {
    topics_.setLightBackground(message.data != 0, *session_, toTime(timer_.stamp()));
  }
  /** Publishes it when it is due by the wall's time: it goes on while the node's clock stands still. */
  void publishStatus();

  // session::Listener
  void bodiesChanged(const std::vector<std::string>& names, bool another_scene) override;
  void previewChanged(const std::string& body) override { topics_.previewChanged(body); }
  void previewEnded(const std::string& body) override { topics_.previewEnded(*session_, body); }
  void keepsAnotherEllipsoid(view::ConservedQuantity keep) override { handles_->showKept(keep); }
  void refused(const session::Refusal& refusal) override;
  void warned(const std::string& warning) override;
  void chose(const std::string& choice) override;
  void seeksFar(double time, double steps) override;
  void timeIsCoarse(double time, double spacing) override;
  void handIsGone(const std::string& body) override;
  void stampsJumpedBack() override;
  void stampsJumpedAhead(double by) override;
  void timeLeftTheRange(double time, double speed) override;

  /** Who looks at the pictures, and from where. */
  struct Viewer {
    ros::Subscriber subscriber;
    std::optional<Eigen::Vector3d> eye;  ///< world axes [m]
  };
  struct Status {
    ros::Publisher publisher;
    ros::SteadyTime sent;
    std::vector<std::string> scenes;  ///< of the package
  };

  const std::atomic<bool>& interrupted_;
  const Parameters parameters_;
  TickTimer timer_;
  session::ThreadJob job_;
  SceneTopics topics_;
  const std::shared_ptr<PublisherStore> publishers_;
  std::unique_ptr<session::Session> session_;
  std::unique_ptr<SpinHandles> handles_;
  std::unique_ptr<Diagnostics> diagnostics_;
  ros::Publisher clock_publisher_;
  Status status_;
  std::vector<ros::Subscriber> subscribers_;
  Viewer viewer_;
  std::unique_ptr<Services> services_;  // last: its thread ends first
};

}  // namespace poinsot::node
