#include "poinsot/ros/body_topics.h"

#include <optional>
#include <utility>

#include "poinsot/ros/body_messages.h"

namespace poinsot::node {
namespace {

constexpr int kQueue = 1000;  // a second's worth at 1 kHz
const ros::WallDuration kKeptUnused(5);

}  // namespace

BodyPublishers::BodyPublishers(ros::NodeHandle handle, const std::string& body)
    : state(handle.advertise<BodyState>(names::topic(body, names::kState), kQueue)),
      odometry(handle.advertise<nav_msgs::Odometry>(names::topic(body, names::kOdometry), kQueue)),
      description(handle.advertise<BodyDescription>(names::topic(body, names::kDescription), 1, true)) {}

std::shared_ptr<const BodyPublishers> PublisherStore::of(const std::string& body) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = kept_.find(body);
    if (found != kept_.end()) return found->second.publishers;
  }
  // Not locked: without a master, advertising waits for one.
  const auto made = std::make_shared<const BodyPublishers>(handle_, body);
  const std::lock_guard<std::mutex> lock(mutex_);
  return kept_.insert({body, {made, ros::SteadyTime::now()}}).first->second.publishers;
}

void PublisherStore::withdrawUnused() {
  std::optional<Kept> withdrawn;  // destroyed last, when the mutex is free: that takes calls to the master
  const std::lock_guard<std::mutex> lock(mutex_);
  const ros::SteadyTime now = ros::SteadyTime::now();
  for (auto it = kept_.begin(); it != kept_.end();) {
    Kept& kept = it->second;
    if (kept.publishers.use_count() > 1) kept.used = now;
    if (!withdrawn && now - kept.used > kKeptUnused) {
      withdrawn = std::move(kept);
      it = kept_.erase(it);
    } else {
      ++it;
    }
  }
}

BodyTopics::BodyTopics(const scene::Body& body, const Motion& motion, const std::string& frame_prefix,
                       std::shared_ptr<const BodyPublishers> publishers, const std::optional<view::PictureFrame>& frame)
    : frames_(frame_prefix, body.name),
      publishers_(std::move(publishers)),
      picture_(body, motion, frames_, BodyPicture::Detail::pictures, frame) {}

void BodyTopics::publish(const session::Body& body, const session::Tick& tick) const {
  const BodyPublishers& to = *publishers_;
  if (to.state.getNumSubscribers() > 0) to.state.publish(stateMessage(body, tick, body.cost()));
  if (to.odometry.getNumSubscribers() > 0) to.odometry.publish(odometryMessage(body, frames_.body, tick));
}

void BodyTopics::publishDescription(const session::Body& body) const {
  publishers_->description.publish(descriptionMessage(body, frames_.body, frame()));
}

BodyTopics& topicsOf(const session::Body& body) {
  return static_cast<BodyTopics&>(body.companion());  // the node's session has no others: see topicsMaker()
}

session::MakeCompanion topicsMaker(const std::shared_ptr<PublisherStore>& publishers, const std::string& frame_prefix,
                                   const std::vector<const session::Body*>& replaced, session::Redraw redraw) {
  std::map<std::string, view::PictureFrame> before;
  for (const session::Body* body : replaced) before.insert({body->name(), topicsOf(*body).frame()});
  return [publishers, frame_prefix, before = std::move(before), redraw](const scene::Body& body, const Motion& motion) {
    std::optional<view::PictureFrame> keep;
    const auto found = before.find(body.name);
    if (found != before.end() && redraw != session::Redraw::always &&
        (redraw == session::Redraw::never || view::hasFairSize(found->second, body.inertia, body.omega_body))) {
      keep = found->second;
    }
    auto topics = std::make_unique<BodyTopics>(body, motion, frame_prefix, publishers->of(body.name), keep);
    if (redraw != session::Redraw::never) topics->picture().faceViewer();
    return topics;
  };
}

}  // namespace poinsot::node
