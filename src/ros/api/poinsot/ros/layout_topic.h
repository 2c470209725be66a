#pragma once

#include <ros/node_handle.h>
#include <ros/time.h>
#include <visualization_msgs/MarkerArray.h>

#include "poinsot/session/session.h"
#include "poinsot/view/scene_layout.h"

namespace poinsot::node {

/** Places the pictures of all bodies, and tells on ~layout how. */
class LayoutTopic {
 public:
  explicit LayoutTopic(ros::NodeHandle private_handle);

  /** Places all pictures. */
  void layOut(const session::Session& session);

  /** Whether viewers have a light background; takes effect with the next layout. */
  void setLightBackground(bool light) { light_background_ = light; }

  /** Appends what the scene draws besides its bodies. */
  void appendDrawings(const session::Session& session, visualization_msgs::MarkerArray& out) const;

  /** Publishes the layout. */
  void publish(const session::Session& session);

  /** Publishes it again while a body flies away, ten times a second at most, and once when it is back. */
  void follow(const session::Session& session);

 private:
  ros::Publisher publisher_;
  view::SceneLayout layout_;
  ros::SteadyTime sent_;
  bool light_background_ = false;
  bool away_ = false;  ///< a body had flown away when it was published last
};

}  // namespace poinsot::node
