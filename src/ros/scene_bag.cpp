#include "poinsot/ros/scene_bag.h"

#include <boost/make_shared.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "poinsot/ros/body_messages.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/layout_message.h"
#include "poinsot/ros/markers/drawings.h"
#include "poinsot/ros/markers/marker_tracker.h"
#include "poinsot/ros/names.h"

namespace poinsot::node {
namespace {

using visualization_msgs::MarkerArray;

constexpr std::uint64_t kFirstStamp = 1000000000;    // ns: not zero, which ROS reads as "no time yet"
const char* const kLayoutTopic = "/poinsot/layout";  // of a node with its usual name
const ros::Duration kRepeatAfter(2);
constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

ros::Time stampAt(double t) {
  ros::Time stamp;
  return stamp.fromNSec(kFirstStamp + static_cast<std::uint64_t>(std::llround(1e9 * t)));
}

std::string absolute(const std::string& topic) {
  return "/" + topic;
}

std::string topicOf(const session::MovingBody& body, const char* what) {
  return absolute(names::topic(body.name(), what));
}

}  // namespace

SceneBag::SceneBag(const std::string& file, const scene::Scene& scene, const Options& options)
    : bag_(std::make_unique<rosbag::Bag>(file, rosbag::bagmode::Write)), markers_(options.markers) {
  entries_.reserve(scene.bodies.size());
  for (const scene::Body& body : scene.bodies) {
    entries_.emplace_back(body, markers_ ? BodyPicture::Detail::pictures : BodyPicture::Detail::none);
    some_body_steps_ = some_body_steps_ || !entries_.back().body.motion().inClosedForm();
  }
  std::vector<BodyPicture*> pictures;
  for (const Entry& entry : entries_) pictures.push_back(entry.picture.get());
  SceneFacts facts;
  facts.some_body_steps = some_body_steps_;
  facts.loop = scene.loop;
  layout_ = layOutScene(pictures, facts);
  drawings_ = scene.drawings;
  extendOverview(drawings_, layout_);
}

SceneBag::Entry::Entry(const scene::Body& scene_body, BodyPicture::Detail detail)
    : body(scene_body),
      frames("", scene_body.name),
      picture(std::make_unique<BodyPicture>(scene_body, body.motion(), frames, detail)) {}

// On a full disk a bag cannot be destroyed: its destructor would write once more, and throw.
SceneBag::~SceneBag() {
  if (bag_ && bag_->isOpen()) static_cast<void>(bag_.release());
}

template <class Message>
void SceneBag::put(const std::string& topic, const Message& message) {
  bag_->write(topic, *stamp_, message);
}

/** Writes a message as rosbag records it, so that rosbag plays it latched. */
template <class Message>
void SceneBag::putLatched(const std::string& topic, const Message& message) {
  const auto header = boost::make_shared<ros::M_string>();
  (*header)["type"] = ros::message_traits::datatype(message);
  (*header)["md5sum"] = ros::message_traits::md5sum(message);
  (*header)["message_definition"] = ros::message_traits::definition(message);
  (*header)["latching"] = "1";
  bag_->write(topic, *stamp_, message, header);
}

void SceneBag::write(double t) {
  const ros::Time stamp = stampAt(t);
  if (stamp_ && stamp <= *stamp_) return;
  const bool first = !stamp_;
  stamp_ = stamp;
  if (first) writeStatic();
  if (!static_markers_repeated_ && stamp >= stampAt(0) + kRepeatAfter) writeStaticMarkers();
  writeMoving({toNanoseconds(stamp), t, 1, 0});
}

void SceneBag::writeStatic() {
  tf2_msgs::TFMessage transforms;
  for (const Entry& entry : entries_) {
    appendStaticTransforms(entry.frames, entry.picture->frame(), *stamp_, transforms.transforms);
    putLatched(topicOf(entry.body, names::kDescription),
               descriptionMessage(entry.body, entry.frames.body, entry.picture->frame()));
  }
  putLatched("/tf_static", transforms);
  if (markers_) writeLayout();
  writeStaticMarkers();
  static_markers_repeated_ = false;
}

void SceneBag::writeLayout() {
  std::vector<LaidOut> bodies;
  for (const Entry& entry : entries_) {
    const BodyPicture& picture = *entry.picture;
    bodies.push_back(
        {entry.body.name(), entry.frames.body, picture.hasPictures(), {entry.body.state().position, picture.reach()}});
  }
  putLatched(kLayoutTopic, layoutMessage(layout_, bodies));
}

// Written twice, for what RViz needs of the node too: see SceneTopics::resendStatic.
void SceneBag::writeStaticMarkers() {
  static_markers_repeated_ = true;
  if (!markers_) return;
  MarkerArray markers;
  for (const Entry& entry : entries_) entry.picture->appendStatic(markers);
  appendDrawings(drawings_, layout_, false, markers);
  clearLeftovers(still_cleared_, markers);
  putLatched(absolute(names::kMarkersStatic), markers);
}

void SceneBag::writeMoving(const session::Tick& tick) {
  transforms_.transforms.clear();
  for (Entry& entry : entries_) {
    entry.body.move(tick);
    appendTransforms(entry.body, entry.frames, *stamp_, transforms_.transforms);
    put(topicOf(entry.body, names::kState), stateMessage(entry.body, tick, kNotMeasured));
    put(topicOf(entry.body, names::kOdometry), odometryMessage(entry.body, entry.frames.body, tick));
  }
  put("/tf", transforms_);
  if (!markers_) return;
  MarkerArray markers;
  for (Entry& entry : entries_) {
    session::MovingBody& body = entry.body;
    entry.picture->appendMoving(tick, body.motion(), body.state(), markers);
    if (!some_body_steps_) continue;
    entry.picture->appendFigures(
        tick, {body.attitudeError(), body.energyDrift(), kNotMeasured, body.state().kinetic_energy}, markers);
  }
  clearLeftovers(moving_cleared_, markers);
  if (!markers.markers.empty()) put(absolute(names::kMarkers), markers);
}

// Viewers of a replay may still show what another recording of these bodies drew.
void SceneBag::clearLeftovers(bool& cleared, MarkerArray& markers) const {
  if (std::exchange(cleared, true)) return;
  std::vector<std::string> names;
  for (const Entry& entry : entries_) names.push_back(entry.body.name());
  MarkerTracker tracker;
  tracker.withdrawLeftovers(names);
  tracker.follow(markers);
}

void SceneBag::close() {
  if (stamp_ && !static_markers_repeated_) writeStaticMarkers();
  bag_->close();
}

}  // namespace poinsot::node
