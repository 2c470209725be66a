#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/ros/markers/body_picture.h"
#include "poinsot/ros/names.h"
#include "poinsot/session/body.h"

namespace poinsot::node {

/** The publishers of one body's topics. A copy shares them. */
struct BodyPublishers {
  BodyPublishers(ros::NodeHandle handle, const std::string& body);
  ros::Publisher state, odometry, description;
};

/** A body on the ROS graph: its frames, its publishers, and its picture. */
class BodyTopics : public session::Companion {
 public:
  BodyTopics(const scene::Body& body, const Motion& motion, const std::string& frame_prefix,
             const BodyPublishers& publishers, const std::optional<view::PictureFrame>& frame);

  const view::PictureFrame& frame() const override { return picture_.frame(); }
  const names::Frames& frames() const { return frames_; }
  BodyPicture& picture() { return picture_; }
  const BodyPublishers& publishers() const { return publishers_; }

  /** State and odometry of the body's last move, to whoever listens. */
  void publish(const session::Body& body, const session::Tick& tick) const;
  void publishDescription(const session::Body& body) const;

 private:
  names::Frames frames_;
  BodyPublishers publishers_;
  BodyPicture picture_;
};

/** Of a body of the node's session. */
BodyTopics& topicsOf(const session::Body& body);

/**
 * Makes the topics of bodies that take the places of others. A body whose name stays keeps its publishers, so that
 * whoever listens to it stays connected.
 */
session::MakeCompanion topicsMaker(const ros::NodeHandle& handle, const std::string& frame_prefix,
                                   const std::vector<const session::Body*>& replaced, session::Redraw redraw);

}  // namespace poinsot::node
