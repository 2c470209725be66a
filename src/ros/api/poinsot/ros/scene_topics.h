#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/time.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <optional>
#include <string>
#include <vector>

#include "poinsot/ros/layout_topic.h"
#include "poinsot/ros/markers/marker_tracker.h"
#include "poinsot/session/session.h"

namespace poinsot::node {

/** The topics of the whole scene: tf and markers, each in two parts, one that stands still and one that moves. */
class SceneTopics {
 public:
  SceneTopics(ros::NodeHandle handle, const ros::NodeHandle& private_handle);

  /** Publishes all that stands still, for the first time. */
  void begin(const session::Session& session, const ros::Time& stamp);
  /** Publishes it again. */
  void publishStatic(const session::Session& session, const ros::Time& stamp);
  /** Another scene plays: deletes all that was drawn. */
  void sceneChanged(const session::Session& session, const ros::Time& stamp);
  /** Bodies of these names were replaced: what is drawn of them begins anew. */
  void bodiesChanged(const session::Session& session, const std::vector<std::string>& names, const ros::Time& stamp);

  /** A body that is held is drawn differently: published with the next tick, at most 20 times a second. */
  void previewChanged(const std::string& body);
  /** The body is drawn as before again. */
  void previewEnded(const session::Session& session, const std::string& body);

  /** Viewers have a light background, or a dark one: all letters are sent again, to be read there. */
  void setLightBackground(bool light, const session::Session& session, const ros::Time& stamp);

  /** Publishes what moves, and the state of each body, at a tick. */
  void publish(const session::Session& session, const session::Tick& tick);

  /** Serves new viewers between two ticks that lie far apart in the wall's time, or while ROS time stands still. */
  void publishToNewViewers(const session::Session& session);

  /** Publishes what stands still once more where that is due. */
  void resendStatic(const session::Session& session);

 private:
  void publishStaticMarkers(const session::Session& session);
  /** Returns whether there was something new to show. */
  bool publishPreview(const session::Session& session);
  /** Publishes what moves, after the deletion of what is to go. */
  void publishMoving(visualization_msgs::MarkerArray markers);
  void publishMarkers(const session::Session& session, const session::Tick& tick);
  /** While this node is young, marks for deletion what an earlier node may have drawn for bodies of these names. */
  void withdrawLeftovers(const session::Session& session, MarkerTracker& markers) const;

  // Not broadcasters of tf2_ros: they have no callback for new subscribers, and never forget the frames of another
  // scene.
  ros::Publisher tf_, static_tf_;
  ros::Publisher markers_, static_markers_;
  MarkerTracker moving_, still_;  ///< what viewers have of markers_ and of static_markers_
  LayoutTopic layout_;
  std::optional<session::Tick> last_tick_;
  tf2_msgs::TFMessage transforms_;  ///< of the last tick
  ros::SteadyTime began_, transforms_sent_;
  bool markers_have_new_viewer_ = false;  ///< since the last tick
  bool markers_watched_ = false;
  std::optional<ros::SteadyTime> resend_static_at_;  ///< for the last subscriber
  struct {
    bool is_new = false;
    ros::SteadyTime sent;
  } preview_;
};

}  // namespace poinsot::node
