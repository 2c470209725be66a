#include "poinsot/ros/body_topics.h"

#include <map>
#include <utility>

#include "poinsot/ros/body_messages.h"

namespace poinsot::node {
namespace {

constexpr int kQueue = 1000;  // a second's worth at 1 kHz

/** What a body leaves to the one that takes its place. */
struct Legacy {
  BodyPublishers publishers;
  view::PictureFrame frame;
};

}  // namespace

BodyPublishers::BodyPublishers(ros::NodeHandle handle, const std::string& body)
    : state(handle.advertise<BodyState>(names::topic(body, names::kState), kQueue)),
      odometry(handle.advertise<nav_msgs::Odometry>(names::topic(body, names::kOdometry), kQueue)),
      description(handle.advertise<BodyDescription>(names::topic(body, names::kDescription), 1, true)) {}

BodyTopics::BodyTopics(const scene::Body& body, const Motion& motion, const std::string& frame_prefix,
                       const BodyPublishers& publishers, const std::optional<view::PictureFrame>& frame)
    : frames_(frame_prefix, body.name),
      publishers_(publishers),
      picture_(body, motion, frames_, BodyPicture::Detail::pictures, frame) {}

void BodyTopics::publish(const session::Body& body, const session::Tick& tick) const {
  if (publishers_.state.getNumSubscribers() > 0) publishers_.state.publish(stateMessage(body, tick, body.cost()));
  if (publishers_.odometry.getNumSubscribers() > 0) {
    publishers_.odometry.publish(odometryMessage(body, frames_.body, tick));
  }
}

void BodyTopics::publishDescription(const session::Body& body) const {
  publishers_.description.publish(descriptionMessage(body, frames_.body, frame().scale));
}

BodyTopics& topicsOf(const session::Body& body) {
  return static_cast<BodyTopics&>(body.companion());  // the node's session has no others: see topicsMaker()
}

session::MakeCompanion topicsMaker(const ros::NodeHandle& handle, const std::string& frame_prefix,
                                   const std::vector<const session::Body*>& replaced, session::Redraw redraw) {
  std::map<std::string, Legacy> legacies;
  for (const session::Body* body : replaced) {
    const BodyTopics& topics = topicsOf(*body);
    legacies.insert({body->name(), {topics.publishers(), topics.frame()}});
  }
  return [handle, frame_prefix, legacies = std::move(legacies), redraw](const scene::Body& body, const Motion& motion) {
    const auto legacy = legacies.find(body.name);
    if (legacy == legacies.end()) {
      return std::make_unique<BodyTopics>(body, motion, frame_prefix, BodyPublishers(handle, body.name), std::nullopt);
    }
    const view::PictureFrame& frame = legacy->second.frame;
    const bool keep = redraw == session::Redraw::never || (redraw == session::Redraw::where_it_has_to_be &&
                                                           view::hasFairSize(frame, body.inertia, body.omega_body));
    return std::make_unique<BodyTopics>(body, motion, frame_prefix, legacy->second.publishers,
                                        keep ? std::make_optional(frame) : std::nullopt);
  };
}

}  // namespace poinsot::node
