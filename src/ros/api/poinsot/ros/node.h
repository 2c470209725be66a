#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <geometry_msgs/PointStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>
#include <std_msgs/Float64.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#include <atomic>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "poinsot/LoadScene.h"
#include "poinsot/NodeStatus.h"
#include "poinsot/SetMethod.h"
#include "poinsot/SetSpin.h"
#include "poinsot/ros/body.h"
#include "poinsot/ros/fair_mutex.h"
#include "poinsot/ros/grip.h"
#include "poinsot/ros/pacer.h"
#include "poinsot/ros/parameters.h"
#include "poinsot/ros/rebuild.h"
#include "poinsot/ros/seeker.h"
#include "poinsot/ros/simulation_clock.h"

namespace poinsot::node {

/**
 * The node: at each tick it asks the clock for the time and every body for its state at that time, and publishes.
 *
 * Ticks run in the caller's thread, services and topics in ROS's; one mutex lies between them. What changes bodies is
 * worked out on a third thread and takes effect at a tick (node_changes.cpp).
 */
class Node {
 public:
  /**
   * @param interrupted makes it give up, here and in run().
   * Throws ParameterError for a scene that this machine cannot step in real time; cost::Cancelled.
   */
  Node(const Parameters& parameters, const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
       const std::atomic<bool>& interrupted);

  /**
   * Ticks until ROS shuts down or somebody interrupts. Throws std::runtime_error when a body has no state that can be
   * published.
   */
  void run();

 private:
  void tick(const ros::Time& now);
  /** Between two ticks that lie far apart in the wall's time, or while ROS time stands still. */
  void idle();
  void serve();                       ///< what waits for no stamp
  double steppingCost() const;        ///< of all bodies together [CPU s per simulated s]
  double stepsTo(double time) const;  ///< of all bodies together
  void publishStatic();
  visualization_msgs::MarkerArray staticMarkers() const;
  void resendStaticMarkers();
  void publishMarkers(const Tick& tick);
  void takeFinishedSeek();
  void seek(double time);
  void jumpTo(double time);
  void diagnoseBody(const std::string& name);
  void publishStatus();

  // What changes bodies.
  /** A scene that is to play instead, or the present one with some bodies changed. */
  struct Change {
    scene::Scene scene, start_scene;  ///< as it is to be; as ~reset is to bring it back
    std::string name, file;
    std::set<std::size_t> bodies;   ///< to be made anew
    bool all = false;               ///< another scene: no body stays
    bool from_start = false;        ///< at t = 0
    bool redraw = false;            ///< pictures are laid out anew
    bool reset = false;             ///< ~reset is part of it
    std::optional<double> seek;     ///< where t is to go when it is done
    std::vector<std::string> what;  ///< is being done, each in words
  };
  /** The scene as it is to be once all that was asked for is done. */
  Change wanted() const;
  Change wantedOfPresentScene() const;  ///< throws scene::Error while another one is being made ready
  void ask(Change change);
  void startRebuild();
  double comingTime() const;  ///< from which t on the change that is being worked out is to play
  void takeFinishedRebuild();
  void exchange(Rebuild::Result&& made);
  void refused(const std::string& what);
  std::size_t indexOf(const std::string& body) const;  ///< throws scene::Error, with the names there are
  void askForSpin(std::size_t body, const Eigen::Vector3d& omega_body);
  /** @return what is done, in words. */
  std::string reset();

  // Taking hold of a spin. Points in the frame of the picture in body axes [m].
  /** A body that somebody holds. */
  struct Hold {
    std::size_t body = 0;
    bool was_paused = false;
    bool led = false;  ///< away from where it was taken
    Eigen::Vector3d taken_at = Eigen::Vector3d::Zero();
    Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();  ///< where it was led to [rad/s]
    bool let_go = false;                                   ///< what was asked for is being worked out
    ros::SteadyTime touched;
    std::unique_ptr<MovingBody> preview;  ///< the body as it would start from there
    bool preview_is_new = false;
    ros::SteadyTime preview_sent;
  };
  void takeTouches();
  void touched(const Touch& touch);
  void press(std::size_t body);
  void lead(const Touch& touch);
  void letGo();
  void endHold();
  void choose(const Touch& touch);
  Eigen::Vector3d omegaPoint(const MovingBody& body) const;
  void placeGrips();
  /** @return whether there was something new to show. */
  bool publishPreview();
  /** What is drawn of a body: what it would be, while somebody holds it. */
  MovingBody& drawn(std::size_t body) const;

  bool onPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool onStep(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool onReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool onLoadScene(LoadScene::Request& request, LoadScene::Response& response);
  bool onSetMethod(SetMethod::Request& request, SetMethod::Response& response);
  bool onSetSpin(SetSpin::Request& request, SetSpin::Response& response);
  void onViewpoint(const geometry_msgs::PointStamped& message);
  void onSpeed(const std_msgs::Float64& message);
  void onSeek(const std_msgs::Float64& message);

  void diagnoseTicks(diagnostic_updater::DiagnosticStatusWrapper& status);

  const std::atomic<bool>& interrupted_;
  FairMutex mutex_;
  SimulationClock clock_;
  Pacer pacer_;
  Seeker seeker_;
  double rate_;
  std::string frame_prefix_;
  scene::Scene scene_;        ///< as it plays, in the order of bodies_
  scene::Scene start_scene_;  ///< as ~reset brings it back
  std::string scene_name_, scene_file_;
  std::vector<std::string> scene_names_;  ///< of the package
  std::vector<std::unique_ptr<Body>> bodies_;
  bool some_body_steps_ = false;  ///< then labels tell how well

  ros::NodeHandle handle_, private_handle_;
  tf2_msgs::TFMessage transforms_;  ///< of the last tick
  ros::SteadyTime transforms_sent_;
  std::optional<Tick> last_tick_;
  bool markers_have_new_viewer_ = false;  ///< since the last tick
  ros::Publisher tf_publisher_;           ///< not a broadcaster: that has no callback for new subscribers
  ros::Publisher clock_publisher_, markers_publisher_, markers_static_publisher_, status_publisher_;
  ros::Publisher static_tf_publisher_;  ///< not a broadcaster, which would never forget the frames of another scene
  std::optional<ros::SteadyTime> resend_static_at_;  ///< for whoever subscribed last
  bool markers_watched_ = false;
  std::vector<ros::ServiceServer> services_;
  std::vector<ros::Subscriber> subscribers_;
  ros::Subscriber viewpoint_subscriber_;
  diagnostic_updater::Updater diagnostics_;

  Rebuild rebuild_;
  std::optional<Change> change_;  ///< that is asked for and not yet there
  bool change_is_newer_ = false;  ///< than what is being worked out
  std::string refused_;           ///< the last of what was refused

  std::unique_ptr<Grip> grip_;
  view::Keep keep_ = view::Keep::energy;
  std::size_t ticks_since_grips_ = 0;
  std::optional<Hold> hold_;
  std::optional<Eigen::Vector3d> eye_;  ///< of whoever looks, world axes [m]
  ros::WallTimer status_timer_;
};

}  // namespace poinsot::node
