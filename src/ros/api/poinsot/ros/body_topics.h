#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/time.h>

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/ros/markers/body_picture.h"
#include "poinsot/ros/names.h"
#include "poinsot/session/body.h"

namespace poinsot::node {

/** The publishers of one body's topics. */
struct BodyPublishers {
  BodyPublishers(ros::NodeHandle handle, const std::string& body);
  ros::Publisher state, odometry, description;
};

/**
 * The publishers of all bodies, by name; any thread may use it. The topics of a body that has gone stay for a few
 * seconds, in case its name comes back: a rospy subscriber that hears of a new publisher before it has noticed that the
 * old connection has ended would never connect again.
 */
class PublisherStore {
 public:
  explicit PublisherStore(const ros::NodeHandle& handle) : handle_(handle) {}

  /** Those of a body of that name. Where there are none yet, it waits for the master to register them. */
  std::shared_ptr<const BodyPublishers> of(const std::string& body);

  /** Withdraws the topics of a body that went some seconds ago; of one only, since each takes calls to the master. */
  void withdrawUnused();

 private:
  struct Kept {
    std::shared_ptr<const BodyPublishers> publishers;
    ros::SteadyTime used;  ///< when a body was last seen to use them
  };
  ros::NodeHandle handle_;
  std::mutex mutex_;
  std::map<std::string, Kept> kept_;
};

/** A body on the ROS graph: its frames, its publishers, and its picture. */
class BodyTopics : public session::Companion {
 public:
  BodyTopics(const scene::Body& body, const Motion& motion, const std::string& frame_prefix,
             std::shared_ptr<const BodyPublishers> publishers, const std::optional<view::PictureFrame>& frame);

  const view::PictureFrame& frame() const override { return picture_.frame(); }
  const names::Frames& frames() const { return frames_; }
  BodyPicture& picture() { return picture_; }

  /** Publishes state and odometry of the body's last move, where somebody listens. */
  void publish(const session::Body& body, const session::Tick& tick) const;
  void publishDescription(const session::Body& body) const;

 private:
  names::Frames frames_;
  std::shared_ptr<const BodyPublishers> publishers_;
  BodyPicture picture_;
};

/** Returns the topics of a body of the node's session. */
BodyTopics& topicsOf(const session::Body& body);

/** Returns what makes the topics of bodies that take the places of `replaced`. */
session::MakeCompanion topicsMaker(const std::shared_ptr<PublisherStore>& publishers, const std::string& frame_prefix,
                                   const std::vector<const session::Body*>& replaced, session::Redraw redraw);

}  // namespace poinsot::node
