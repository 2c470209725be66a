#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/time.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <optional>
#include <string>
#include <vector>

#include "poinsot/ros/markers/marker_tracker.h"
#include "poinsot/session/session.h"

namespace poinsot::node {

/** The topics of the scene as a whole: tf and markers, each in two parts, one that stands still and one that moves. */
class SceneTopics {
 public:
  explicit SceneTopics(ros::NodeHandle handle);

  /** All that stands still, for the first time. */
  void begin(const session::Session& session, const ros::Time& stamp);
  /** The same again. */
  void publishStatic(const session::Session& session, const ros::Time& stamp);
  /** Another scene plays: all that was drawn goes. */
  void sceneChanged(const session::Session& session, const ros::Time& stamp);
  /** Bodies of these names are others now: what is drawn of them begins anew. */
  void bodiesChanged(const session::Session& session, const std::vector<std::string>& names, const ros::Time& stamp);

  /** A body that is held is drawn otherwise: told with the next tick, but not too often. */
  void previewChanged(const std::string& body);
  /** It is drawn again as it was. */
  void previewEnded(const session::Session& session, const std::string& body);

  /** What moves, and what each body says, at a tick. */
  void publish(const session::Session& session, const session::Tick& tick);

  /** Between two ticks that lie far apart in the wall's time, or while ROS time stands still. */
  void publishToNewViewers(const session::Session& session);

  /** Sends what stands still once more where that is due. */
  void resendStatic(const session::Session& session);

 private:
  void publishStaticMarkers(const session::Session& session);
  /** @return whether there was something new to show. */
  bool publishPreview(const session::Session& session);
  /** What moves, after the deletion of what is to go. */
  void publishMoving(visualization_msgs::MarkerArray markers);
  void publishMarkers(const session::Session& session, const session::Tick& tick);
  /** What a node that has ended may have drawn in the names of these bodies goes, while this one is young. */
  void withdrawLeftovers(const session::Session& session, MarkerTracker& markers) const;

  // Not broadcasters of tf2_ros: they have no callback for new subscribers, and never forget the frames of another
  // scene.
  ros::Publisher tf_, static_tf_;
  ros::Publisher markers_, static_markers_;
  MarkerTracker moving_, still_;  ///< what viewers have of markers_ and of static_markers_
  std::optional<session::Tick> last_tick_;
  tf2_msgs::TFMessage transforms_;  ///< of the last tick
  ros::SteadyTime began_, transforms_sent_, preview_sent_;
  bool markers_have_new_viewer_ = false;  ///< since the last tick
  bool markers_watched_ = false;
  std::optional<ros::SteadyTime> resend_static_at_;  ///< for whoever subscribed last
  bool preview_is_new_ = false;
};

}  // namespace poinsot::node
