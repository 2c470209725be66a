#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/time.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <optional>

#include "poinsot/session/session.h"

namespace poinsot::node {

/** The topics of the scene as a whole: tf and markers, each in two parts, one that stands still and one that moves. */
class SceneTopics {
 public:
  explicit SceneTopics(const ros::NodeHandle& handle);

  /** All that stands still. */
  void publishStatic(const session::Session& session, const ros::Time& stamp);
  /** Other bodies play: what stands still is sent, and what moves begins anew. @param all see Listener. */
  void bodiesChanged(const session::Session& session, bool all, const ros::Time& stamp);

  /** A body that is held is drawn otherwise: told with the next tick, but not too often. */
  void previewChanged() { preview_is_new_ = true; }
  /** It is drawn again as it was. */
  void previewEnded(const session::Session& session);

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
  void publishMarkers(const session::Session& session, const session::Tick& tick);

  ros::NodeHandle handle_;
  // Not broadcasters of tf2_ros: they have no callback for new subscribers, and never forget the frames of another
  // scene.
  ros::Publisher tf_, static_tf_;
  ros::Publisher markers_, static_markers_;
  std::optional<session::Tick> last_tick_;
  tf2_msgs::TFMessage transforms_;  ///< of the last tick
  ros::SteadyTime transforms_sent_, preview_sent_;
  bool markers_have_new_viewer_ = false;  ///< since the last tick
  bool markers_watched_ = false;
  std::optional<ros::SteadyTime> resend_static_at_;  ///< for whoever subscribed last
  bool preview_is_new_ = false;
  bool has_preview_ = false;  ///< of what was published last
};

}  // namespace poinsot::node
