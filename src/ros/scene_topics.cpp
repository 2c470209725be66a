#include "poinsot/ros/scene_topics.h"

#include <ros/single_subscriber_publisher.h>

#include <algorithm>
#include <utility>

#include "poinsot/cost/cpu_time.h"
#include "poinsot/ros/body_messages.h"
#include "poinsot/ros/body_topics.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/names.h"

namespace poinsot::node {
namespace {

using session::Session;
using visualization_msgs::MarkerArray;

constexpr int kMarkerQueue = 100;
constexpr int kTfQueue = 100;
const ros::WallDuration kResendAfter(2);
const ros::WallDuration kResendAfterScene(0.5);  // its frames are new to everybody
const ros::WallDuration kNextIsFar(0.1);         // since the last tick: then a new viewer is sent that one
const ros::WallDuration kPreviewPause(0.05);
const ros::WallDuration kYouth(10);  // within it, viewers connect again to a node that was restarted

Figures figuresOf(const session::Body& body) {
  return {body.attitudeError(), body.energyDrift(), body.cost(), body.state().kinetic_energy};
}

}  // namespace

SceneTopics::SceneTopics(ros::NodeHandle handle, const ros::NodeHandle& private_handle) : layout_(private_handle) {
  // A subscriber that comes while ROS time stands still is sent the last tick: no other may come.
  tf_ =
      handle.advertise<tf2_msgs::TFMessage>(names::kTf, kTfQueue, [this](const ros::SingleSubscriberPublisher& viewer) {
        const bool next_is_far = ros::SteadyTime::now() - transforms_sent_ > kNextIsFar;
        if (next_is_far && !transforms_.transforms.empty()) viewer.publish(transforms_);
      });
  static_tf_ = handle.advertise<tf2_msgs::TFMessage>(names::kTfStatic, 10, true);
  markers_ =
      handle.advertise<MarkerArray>(names::kMarkers, kMarkerQueue,
                                    [this](const ros::SingleSubscriberPublisher&) { markers_have_new_viewer_ = true; });
  static_markers_ = handle.advertise<MarkerArray>(
      names::kMarkersStatic, 1,
      [this](const ros::SingleSubscriberPublisher&) { resend_static_at_ = ros::SteadyTime::now() + kResendAfter; },
      ros::SubscriberStatusCallback(), ros::VoidConstPtr(), true);
}

void SceneTopics::begin(const Session& session, const ros::Time& stamp) {
  began_ = ros::SteadyTime::now();
  layout_.layOut(session);
  publishStatic(session, stamp);
}

void SceneTopics::publishStatic(const Session& session, const ros::Time& stamp) {
  // One message for all bodies: a replayed bag gives only the last message of a latched topic.
  tf2_msgs::TFMessage transforms;
  for (const auto& body : session.bodies()) {
    const BodyTopics& topics = topicsOf(*body);
    appendStaticTransforms(topics.frames(), topics.frame(), stamp, transforms.transforms);
    topics.publishDescription(*body);
  }
  static_tf_.publish(transforms);
  layout_.publish(session);
  publishStaticMarkers(session);
}

void SceneTopics::sceneChanged(const Session& session, const ros::Time& stamp) {
  // New viewers are not sent what the old scene had sent, and viewers that are there no longer see it.
  resend_static_at_ = ros::SteadyTime::now() + kResendAfterScene;
  preview_.is_new = false;
  transforms_.transforms.clear();
  last_tick_.reset();
  moving_.withdrawAll();
  publishMoving({});
  layout_.layOut(session);
  publishStatic(session, stamp);
}

void SceneTopics::bodiesChanged(const Session& session, const std::vector<std::string>& names, const ros::Time& stamp) {
  preview_.is_new = false;
  for (const std::string& name : names) moving_.withdraw(name);
  layout_.layOut(session);
  publishStatic(session, stamp);
}

void SceneTopics::setLightBackground(bool light, const Session& session, const ros::Time& stamp) {
  layout_.setLightBackground(light);
  layout_.layOut(session);
  publishStatic(session, stamp);
  markers_have_new_viewer_ = true;
  for (const auto& body : session.bodies()) topicsOf(*body).picture().sendAllNext();
}

void SceneTopics::previewChanged(const std::string& body) {
  preview_.is_new = true;
  moving_.withdraw(body);  // the trail and the words are those of the spin before
}

void SceneTopics::previewEnded(const Session& session, const std::string& body) {
  preview_.is_new = false;
  moving_.withdraw(body);
  publishStaticMarkers(session);
}

void SceneTopics::withdrawLeftovers(const Session& session, MarkerTracker& markers) const {
  if (ros::SteadyTime::now() - began_ > kYouth) return;
  std::vector<std::string> names;
  for (const auto& body : session.bodies()) names.push_back(body->name());
  markers.withdrawLeftovers(names);
}

void SceneTopics::publishStaticMarkers(const Session& session) {
  MarkerArray markers;
  for (std::size_t i = 0; i < session.bodies().size(); ++i) topicsOf(session.drawn(i)).picture().appendStatic(markers);
  layout_.appendDrawings(session, markers);
  still_.withdrawAll();
  still_.withdrawAgain();  // a slow viewer is sent only the last of several messages
  withdrawLeftovers(session, still_);
  still_.follow(markers);
  static_markers_.publish(markers);
}

// RViz loses a latched marker that reaches it before the frames do: as soon as they come, tf2 holds the marker's stamp
// 0 to be older than all it knows. A second copy finds them there.
void SceneTopics::resendStatic(const Session& session) {
  if (!resend_static_at_ || ros::SteadyTime::now() < *resend_static_at_) return;
  resend_static_at_.reset();
  publishStaticMarkers(session);
  still_.forgetGone();
}

void SceneTopics::publish(const Session& session, const session::Tick& tick) {
  const ros::Time stamp = toTime(tick.stamp);
  last_tick_ = tick;
  transforms_.transforms.clear();
  for (const auto& body : session.bodies()) {
    appendTransforms(*body, topicsOf(*body).frames(), stamp, transforms_.transforms);
  }
  tf_.publish(transforms_);
  transforms_sent_ = ros::SteadyTime::now();
  for (const auto& body : session.bodies()) topicsOf(*body).publish(*body, tick);
  layout_.follow(session);
  publishPreview(session);
  publishMarkers(session, tick);
}

void SceneTopics::publishToNewViewers(const Session& session) {
  const bool preview_is_new = publishPreview(session);
  if (!last_tick_ || !(preview_is_new || markers_have_new_viewer_)) return;
  for (std::size_t i = 0; i < session.bodies().size(); ++i) topicsOf(session.drawn(i)).picture().sendAllNext();
  publishMarkers(session, *last_tick_);
}

bool SceneTopics::publishPreview(const Session& session) {
  if (!session.preview() || !preview_.is_new || ros::SteadyTime::now() - preview_.sent < kPreviewPause) return false;
  preview_.is_new = false;
  preview_.sent = ros::SteadyTime::now();
  publishStaticMarkers(session);
  return true;
}

void SceneTopics::publishMoving(MarkerArray markers) {
  moving_.follow(markers);
  moving_.forgetGone();  // not to be repeated: this topic's queue is long
  if (!markers.markers.empty()) markers_.publish(markers);
}

void SceneTopics::publishMarkers(const Session& session, const session::Tick& tick) {
  if (markers_have_new_viewer_) withdrawLeftovers(session, moving_);
  markers_have_new_viewer_ = false;
  const auto& bodies = session.bodies();
  const bool watched = markers_.getNumSubscribers() > 0;
  if (watched) {
    const bool some_body_steps =
        std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return !body->motion().inClosedForm(); });
    MarkerArray markers;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const session::Body& body = session.drawn(i);
      BodyPicture& picture = topicsOf(body).picture();
      picture.appendMoving(tick, body.motion(), body.state(), markers);
      // Figures tell how well a body steps; one that is only a preview does not step.
      if (some_body_steps && &body == bodies[i].get()) picture.appendFigures(tick, figuresOf(body), markers);
    }
    publishMoving(std::move(markers));
  } else if (markers_watched_) {
    for (const auto& body : bodies) topicsOf(*body).picture().clearTrail();
  }
  markers_watched_ = watched;
}

}  // namespace poinsot::node
