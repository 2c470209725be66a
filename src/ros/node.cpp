#include "poinsot/ros/node.h"

#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/init.h>
#include <rosgraph_msgs/Clock.h>

#include <utility>

#include "poinsot/core/number_text.h"
#include "poinsot/cost/cpu_time.h"
#include "poinsot/ros/body_topics.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/markers/meshes.h"
#include "poinsot/ros/names.h"
#include "poinsot/ros/scene_list.h"
#include "poinsot/ros/scene_text.h"
#include "poinsot/ros/session_text.h"
#include "poinsot/ros/status_message.h"
#include "poinsot/scene/reader.h"

namespace poinsot::node {
namespace {

constexpr int kControlQueue = 100;
constexpr std::chrono::seconds kPatience{1};  // until a job that was told to end has ended
const ros::WallDuration kPatienceForClock(3);
const ros::WallDuration kStatusPause(0.095);  // ten times a second, also where ticks come a little early

TickTimer::Mode pacing(bool publish_clock) {
  if (publish_clock) return TickTimer::Mode::own_clock;
  return ros::Time::isSimTime() ? TickTimer::Mode::foreign_clock : TickTimer::Mode::wall;
}

session::Nanoseconds wallTime() {
  return static_cast<session::Nanoseconds>(ros::SteadyTime::now().toNSec());
}

/** Returns the scene; throws where a mesh is missing, or where a body's frame would be "world". */
session::NamedScene readScene(const std::string& file, const std::string& frame_prefix) {
  session::NamedScene out;
  out.file = file;
  out.name = sceneName(file);
  out.scene = scene::readFile(file);
  requireMeshes(out.scene);
  checkPrefix(frame_prefix, out.scene);
  return out;
}

}  // namespace

Node::Node(const Parameters& parameters, const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
           const std::atomic<bool>& interrupted)
    : interrupted_(interrupted),
      parameters_(parameters),
      timer_(pacing(parameters.publish_clock), parameters.rate, *ros::getGlobalCallbackQueue()),
      topics_(handle, private_handle),
      publishers_(std::make_shared<PublisherStore>(handle)) {
  for (const std::string& warning : parameters.scene.warnings) warned(warning);
  if (parameters.publish_clock) {
    if (!ros::Time::isSimTime()) warned("~publish_clock is on, but /use_sim_time is not set: nobody follows /clock");
    clock_publisher_ = ros::NodeHandle(handle).advertise<rosgraph_msgs::Clock>(names::kClock, 10);
  }

  session::Session::Options options;
  options.rate = parameters.rate;
  options.find = sceneFile;
  options.read = [prefix = parameters.frame_prefix](const std::string& file) { return readScene(file, prefix); };
  options.companions = [publishers = publishers_, prefix = parameters.frame_prefix](const auto& replaced,
                                                                                    session::Redraw redraw) {
    return topicsMaker(publishers, prefix, replaced, redraw);
  };
  session::Built built = session::build(
      session::wholeScene(parameters.scene, parameters.rate, options.companions({}, session::Redraw::always)),
      interrupted_);
  for (const std::string& choice : built.choices) chose(choice);
  const session::NamedScene scene{built.scene, sceneName(parameters.scene_file), parameters.scene_file};
  session::Listener& listener = *this;
  session_ = std::make_unique<session::Session>(options, scene, std::move(built), job_, listener);
  if (session_->steppingCost() > session::kMostLoad) {
    throw ParameterError("expected steps that cost at most " + numberText(session::kMostLoad) +
                         " CPU s per simulated s, got " + numberText(session_->steppingCost()) +
                         ": this machine cannot play the scene in real time; take larger steps, or " + kClosedForm +
                         ", which has none");
  }
  const std::string played = parameters.scene_file.empty()
                                 ? "the scene of parameter " + private_handle.resolveName(names::kScene)
                                 : "scene " + scene.name + " (" + scene.file + ")";
  ROS_INFO(
      "%s",
      playedText(session_->scene(), {played, parameters.rate, handle.getNamespace(), parameters.frame_prefix}).c_str());

  ros::NodeHandle own(private_handle);
  handles_ = std::make_unique<SpinHandles>(own);
  diagnostics_ = std::make_unique<Diagnostics>(handle, own, parameters.rate, timer_, *session_);
  status_.publisher = own.advertise<NodeStatus>(names::kStatus, 10);
  status_.scenes = sceneNames();
  subscribers_ = {own.subscribe(names::kSpeed, kControlQueue, &Node::onSpeed, this),
                  own.subscribe(names::kSeek, kControlQueue, &Node::onSeek, this),
                  own.subscribe(names::kLightBackground, 1, &Node::onLightBackground, this)};
  viewer_.subscriber = own.subscribe(names::kViewpoint, 1, &Node::onViewpoint, this);
  services_ = std::make_unique<Services>(
      own, parameters.rate, *ros::getGlobalCallbackQueue(),
      [this](const session::Request& request, const session::Session::Reply& reply) { session_->ask(request, reply); },
      interrupted_);
}

Node::~Node() {
  job_.cancel();
  // Where the master is gone, roscpp tries to advertise a new body's topics until ROS shuts down.
  while (!job_.endsWithin(kPatience)) ros::requestShutdown();
}

void Node::run() {
  topics_.begin(*session_, toTime(timer_.stamp()));
  const session::Nanoseconds began = wallTime();
  bool began_to_tick = false, said = false;
  for (TickTimer::Wake wake; (wake = timer_.wait(interrupted_)) != TickTimer::Wake::ended;) {
    serve();
    const session::Nanoseconds now = timer_.stamp();
    if (now == 0 && !began_to_tick && !said && wallTime() - began > kPatienceForClock.toNSec()) {
      warned("/use_sim_time is set, but nobody publishes /clock: nothing moves until somebody does");
      said = true;
    }
    if (wake == TickTimer::Wake::due && now != 0) {
      tick(now);
      began_to_tick = true;
    } else {
      topics_.publishToNewViewers(*session_);
    }
    handles_->update(*session_);
    diagnostics_->update();
    publishStatus();
  }
}

void Node::tick(session::Nanoseconds now) {
  if (clock_publisher_) {
    rosgraph_msgs::Clock message;
    message.clock = toTime(now);
    clock_publisher_.publish(message);
  }
  cost::threadCpuTime();  // the first call after a sleep is slow, which the first body would be charged with
  if (const std::optional<session::Tick> tick = session_->tick(now)) topics_.publish(*session_, *tick);
}

void Node::serve() {
  topics_.resendStatic(*session_);
  publishers_->withdrawUnused();
  const bool looks = viewer_.subscriber.getNumPublishers() > 0;  // else the viewer is gone
  for (const session::HandleEvent& event : handles_->take()) {
    session_->touch(event, wallTime(), looks ? viewer_.eye : std::nullopt,
                    names::Frames(parameters_.frame_prefix, event.body).model);
  }
  session_->serve(wallTime());
}

void Node::onViewpoint(const geometry_msgs::PointStamped& message) {
  const Eigen::Vector3d eye(message.point.x, message.point.y, message.point.z);
  if (message.header.frame_id != names::kWorld || !eye.allFinite()) {
    ROS_WARN_THROTTLE(10, "viewpoint ignored: expected finite coordinates in frame %s, got (%g, %g, %g) in frame %s",
                      names::kWorld, eye.x(), eye.y(), eye.z(), message.header.frame_id.c_str());
    return;
  }
  viewer_.eye = eye;
}

void Node::publishStatus() {
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (status_.publisher.getNumSubscribers() == 0 || now - status_.sent < kStatusPause) return;
  status_.sent = now;
  status_.publisher.publish(statusMessage(*session_, parameters_.rate, timer_.waitsForClock(), status_.scenes));
}

void Node::bodiesChanged(const std::vector<std::string>& names, bool another_scene) {
  if (another_scene) {
    handles_->removeAll();
    diagnostics_->bodiesChanged();
    topics_.sceneChanged(*session_, toTime(timer_.stamp()));
  } else {
    topics_.bodiesChanged(*session_, names, toTime(timer_.stamp()));
  }
}

void Node::refused(const session::Refusal& refusal) {
  ROS_ERROR("%s", textOf(refusal).c_str());
}

void Node::warned(const std::string& warning) {
  ROS_WARN("%s", warning.c_str());
}

void Node::chose(const std::string& choice) {
  ROS_INFO("%s", choice.c_str());
}

void Node::seeksFar(double time, double steps) {
  ROS_INFO("seek to %g s takes %.3g steps; playing on meanwhile", time, steps);
}

void Node::timeIsCoarse(double time, double spacing) {
  ROS_WARN("at t = %g s doubles lie %g s apart: t, and every motion with it, goes on in jumps of that length", time,
           spacing);
}

void Node::handIsGone(const std::string& body) {
  ROS_WARN("the viewer that held %s is gone: the body goes on as before", body.c_str());
}

void Node::stampsJumpedBack() {
  ROS_WARN("ROS time jumped back: what is static is sent again, and a new segment begins");
  topics_.publishStatic(*session_, toTime(timer_.stamp()));
  diagnostics_->publish();  // which would else wait for the old time to come again
}

void Node::stampsJumpedAhead(double by) {
  ROS_WARN_THROTTLE(1,
                    "ROS time is %g s further than at the last tick, too far to step at once: t goes on from where it "
                    "was, in a new segment",
                    by);
}

void Node::timeLeftTheRange(double time, double speed) {
  ROS_ERROR("t = %g s at speed %g leaves the range of doubles: paused there, in a new segment", time, speed);
}

}  // namespace poinsot::node
