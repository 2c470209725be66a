#include "poinsot/ros/node.h"

#include <ros/spinner.h>
#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "poinsot/cost/cancelled.h"
#include "poinsot/cost/cpu_time.h"
#include "poinsot/ros/limits.h"
#include "poinsot/ros/names.h"
#include "poinsot/ros/number_text.h"
#include "poinsot/ros/scene_list.h"

namespace poinsot::node {
namespace {

using visualization_msgs::MarkerArray;

constexpr int kMarkerQueue = 100;
constexpr int kTfQueue = 100;
constexpr int kControlQueue = 100;
const ros::WallDuration kResendAfter(2);
const ros::WallDuration kPatienceForClock(3);
const ros::WallDuration kNextIsFar(0.1);  // the next tick, so that a new viewer is given the last one
const ros::WallDuration kStatusPause(0.1);
constexpr double kBackgroundSeekSteps = 2e4;  // about 2 ms: more is not done between two ticks
constexpr double kAstray = 0.1;               // rad from the truth: /diagnostics warns
constexpr double kCoarseShare = 0.1;          // of a tick: where doubles lie further apart, t is seen to jump

Pacer::Mode pacing(bool publish_clock) {
  if (publish_clock) return Pacer::Mode::own_clock;
  return ros::Time::isSimTime() ? Pacer::Mode::foreign_clock : Pacer::Mode::wall;
}

}  // namespace

Node::Node(const Parameters& parameters, const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
           const std::atomic<bool>& interrupted)
    : interrupted_(interrupted),
      clock_(1 / parameters.rate),
      pacer_(pacing(parameters.publish_clock), parameters.rate),
      rate_(parameters.rate),
      frame_prefix_(parameters.frame_prefix),
      scene_(parameters.scene),
      start_scene_(parameters.scene),
      scene_name_(sceneName(parameters.scene_file)),
      scene_file_(parameters.scene_file),
      scene_names_(sceneNames()),
      handle_(handle),
      private_handle_(private_handle),
      diagnostics_(handle, private_handle) {
  for (const std::string& warning : parameters.scene.warnings) ROS_WARN("%s", warning.c_str());
  for (const std::string& choice : parameters.choices) ROS_INFO("%s", choice.c_str());
  if (parameters.publish_clock) {
    if (!ros::Time::isSimTime()) ROS_WARN("~publish_clock is on, but /use_sim_time is not set: nobody follows /clock");
    clock_publisher_ = handle_.advertise<rosgraph_msgs::Clock>(names::kClock, 10);
  }
  // Who comes while ROS time stands still is given the last tick: there is no next one to wait for.
  tf_publisher_ = handle_.advertise<tf2_msgs::TFMessage>(
      names::kTf, kTfQueue, [this](const ros::SingleSubscriberPublisher& viewer) {
        const std::lock_guard<FairMutex> lock(mutex_);
        const bool next_is_far = ros::SteadyTime::now() - transforms_sent_ > kNextIsFar;
        if (next_is_far && !transforms_.transforms.empty()) viewer.publish(transforms_);
      });
  markers_publisher_ =
      handle_.advertise<MarkerArray>(names::kMarkers, kMarkerQueue, [this](const ros::SingleSubscriberPublisher&) {
        const std::lock_guard<FairMutex> lock(mutex_);
        markers_have_new_viewer_ = true;
      });
  markers_static_publisher_ = handle_.advertise<MarkerArray>(
      names::kMarkersStatic, 1,
      [this](const ros::SingleSubscriberPublisher&) {
        const std::lock_guard<FairMutex> lock(mutex_);
        resend_static_at_ = ros::SteadyTime::now() + kResendAfter;
      },
      ros::SubscriberStatusCallback(), ros::VoidConstPtr(), true);

  static_tf_publisher_ = handle_.advertise<tf2_msgs::TFMessage>(names::kTfStatic, 10, true);
  status_publisher_ = private_handle_.advertise<NodeStatus>(names::kStatus, 10);

  diagnostics_.setHardwareID("none");
  diagnostics_.add("ticks", this, &Node::diagnoseTicks);
  for (const scene::Body& body : parameters.scene.bodies) {
    cost::throwIf(interrupted_);
    bodies_.push_back(std::make_unique<Body>(body, parameters.frame_prefix, rate_, handle_));
    some_body_steps_ = some_body_steps_ || !bodies_.back()->motion().inClosedForm();
    diagnoseBody(body.name);
  }

  if (steppingCost() > kMostLoad) {
    throw ParameterError("the steps of this scene cost " + shown(steppingCost()) +
                         " CPU s per simulated s here, which cannot be played in real time; at most " +
                         shown(kMostLoad) + " can: take larger steps, or " + kClosedForm + ", which has none");
  }

  services_ = {private_handle_.advertiseService(names::kPause, &Node::onPause, this),
               private_handle_.advertiseService(names::kStep, &Node::onStep, this),
               private_handle_.advertiseService(names::kReset, &Node::onReset, this),
               private_handle_.advertiseService(names::kLoadScene, &Node::onLoadScene, this),
               private_handle_.advertiseService(names::kSetMethod, &Node::onSetMethod, this),
               private_handle_.advertiseService(names::kSetSpin, &Node::onSetSpin, this)};
  subscribers_ = {private_handle_.subscribe(names::kSpeed, kControlQueue, &Node::onSpeed, this),
                  private_handle_.subscribe(names::kSeek, kControlQueue, &Node::onSeek, this)};
  viewpoint_subscriber_ = private_handle_.subscribe(names::kViewpoint, 1, &Node::onViewpoint, this);
  grip_ = std::make_unique<Grip>(private_handle_);
  // By the wall, so that one can tell a node whose clock stands still from one that is gone.
  status_timer_ = handle_.createWallTimer(kStatusPause, [this](const ros::WallTimerEvent&) { publishStatus(); });
}

void Node::diagnoseBody(const std::string& name) {
  diagnostics_.add("body " + name, [this, name](diagnostic_updater::DiagnosticStatusWrapper& status) {
    const Body& body = *bodies_[indexOf(name)];
    const MotionSetup& setup = body.motion().setup();
    const std::string step = setup.step ? ", step " + shown(*setup.step) + " s" : "";
    const BodyPicture::Figures figures = body.figures();
    const bool astray = figures.attitude_error > kAstray;
    status.summary(astray ? diagnostic_msgs::DiagnosticStatus::WARN : diagnostic_msgs::DiagnosticStatus::OK,
                   setup.method + step + (astray ? ": " + shown(figures.attitude_error) + " rad astray" : ""));
    status.addf("simulation time [s]", "%.9g", body.state().time);
    if (!body.motion().torques()) status.addf("attitude error [rad]", "%.3g", figures.attitude_error);
    status.addf("energy [J]", "%.6g", figures.kinetic_energy);
    status.addf("energy drift", "%.3g", figures.energy_drift);
    status.addf("momentum drift", "%.3g", body.momentumDrift());
    status.addf("cost [CPU s per simulated s]", "%.3g", figures.cost);
  });
}

double Node::steppingCost() const {
  double sum = 0;
  for (const auto& body : bodies_) sum += body->cost().steppingCost();
  return sum;
}

void Node::run() {
  ros::AsyncSpinner spinner(1);
  spinner.start();
  {
    const std::lock_guard<FairMutex> lock(mutex_);
    publishStatic();
  }
  const ros::SteadyTime began = ros::SteadyTime::now();
  bool warned = false;
  for (Pacer::Wake wake; (wake = pacer_.wait(interrupted_)) != Pacer::Wake::ended;) {
    const std::lock_guard<FairMutex> lock(mutex_);
    const ros::Time now = pacer_.stamp();
    if (now.isZero() && !last_tick_ && !warned && ros::SteadyTime::now() - began > kPatienceForClock) {
      ROS_WARN("/use_sim_time is set, but nobody publishes /clock: nothing moves until somebody does");
      warned = true;
    }
    if (wake == Pacer::Wake::due && !now.isZero()) {
      tick(now);
    } else {
      idle();
    }
    diagnostics_.update();
  }
  spinner.stop();
}

void Node::tick(const ros::Time& now) {
  if (clock_publisher_) {
    rosgraph_msgs::Clock message;
    message.clock = now;
    clock_publisher_.publish(message);
  }
  if (clock_.jumpedBack(now)) {
    ROS_WARN("ROS time jumped back: what is static is sent again, and a new segment begins");
    clock_.restartStamps();
    publishStatic();
    diagnostics_.force_update();  // which would else wait for the old time to come again
  } else if (!std::isfinite(clock_.timeAt(now))) {
    ROS_ERROR("t = %g s at speed %g leaves the range of doubles: paused there, in a new segment", clock_.time(),
              clock_.speed());
    clock_.pause(true);
    clock_.restartStamps();
  } else if (stepsTo(clock_.timeAt(now)) > kMostTickSteps) {  // the clock has jumped, or runs too fast to follow
    ROS_WARN_THROTTLE(
        1,
        "ROS time is %g s further than at the last tick, too far to step at once: t goes on from where it "
        "was, in a new segment",
        (now - clock_.stamp()).toSec());
    clock_.restartStamps();
  }
  serve();
  const std::optional<Tick> tick = clock_.tick(now);
  if (!tick) return;

  last_tick_ = tick;
  transforms_.transforms.clear();
  cost::threadCpuTime();  // the first call after a sleep is slow, which the first body would be charged with
  for (const auto& body : bodies_) {
    body->move(*tick);
    body->appendTransforms(tick->stamp, transforms_.transforms);
  }
  tf_publisher_.publish(transforms_);
  transforms_sent_ = ros::SteadyTime::now();
  for (const auto& body : bodies_) body->publish(*tick);
  publishPreview();
  publishMarkers(*tick);
  placeGrips();
}

void Node::idle() {
  serve();
  const bool preview_is_new = publishPreview();
  if (last_tick_ && (preview_is_new || markers_have_new_viewer_)) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) drawn(i).picture().sendAllNext();
    publishMarkers(*last_tick_);
  }
  placeGrips();
}

void Node::serve() {
  resendStaticMarkers();
  takeFinishedSeek();
  takeFinishedRebuild();
  takeTouches();
}

double Node::stepsTo(double time) const {
  double sum = 0;
  for (const auto& body : bodies_) sum += body->motion().stepsTo(time);
  return sum;
}

void Node::publishStatic() {
  const ros::Time stamp = pacer_.stamp();
  // One message for all: whoever replays a bag gets the last one of a latched topic only.
  tf2_msgs::TFMessage transforms;
  for (const auto& body : bodies_) {
    body->appendStaticTransforms(stamp, transforms.transforms);
    body->publishDescription();
  }
  static_tf_publisher_.publish(transforms);
  markers_static_publisher_.publish(staticMarkers());
}

MarkerArray Node::staticMarkers() const {
  MarkerArray markers = clearedMarkers();
  for (std::size_t i = 0; i < bodies_.size(); ++i) drawn(i).picture().appendStatic(markers);
  return markers;
}

// RViz loses a latched marker that reaches it before the frames do: as soon as they come, tf2 holds the marker's stamp
// 0 to be older than all it knows. A second copy finds them there.
void Node::resendStaticMarkers() {
  if (!resend_static_at_ || ros::SteadyTime::now() < *resend_static_at_) return;
  resend_static_at_.reset();
  markers_static_publisher_.publish(staticMarkers());
}

void Node::publishMarkers(const Tick& tick) {
  markers_have_new_viewer_ = false;
  const bool watched = markers_publisher_.getNumSubscribers() > 0;
  if (watched) {
    MarkerArray markers = markers_watched_ ? MarkerArray() : clearedMarkers();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      MovingBody& body = drawn(i);
      body.picture().appendMoving(tick, body.motion(), body.state(), markers);
      if (some_body_steps_) bodies_[i]->picture().appendFigures(tick, bodies_[i]->figures(), markers);
    }
    if (!markers.markers.empty()) markers_publisher_.publish(markers);
  } else if (markers_watched_) {
    for (const auto& body : bodies_) body->picture().clearTrail();
  }
  markers_watched_ = watched;
}

void Node::takeFinishedSeek() {
  std::optional<Seeker::Result> result;
  try {
    result = seeker_.poll();
  } catch (const std::runtime_error& error) {  // range_error, NoConvergence
    refused(std::string("seek refused: ") + error.what() + " there");
  }
  if (!result) return;
  for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i]->replaceMotion(std::move(result->motions[i]));
  jumpTo(result->time);
}

void Node::jumpTo(double time) {
  const double spacing = std::nextafter(std::abs(time), HUGE_VAL) - std::abs(time);
  if (spacing > kCoarseShare / rate_) {
    ROS_WARN("at t = %g s doubles lie %g s apart: t, and every motion with it, goes on in jumps of that length", time,
             spacing);
  }
  clock_.jumpTo(time);
  refused_.clear();
}

bool Node::onPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
  const std::lock_guard<FairMutex> lock(mutex_);
  if (hold_) {
    hold_->was_paused = request.data;  // as soon as it is let go
  } else {
    clock_.pause(request.data);
  }
  refused_.clear();
  response.success = true;
  response.message = request.data ? "paused" : "playing";  // where, the next tick tells
  return true;
}

bool Node::onStep(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  const std::lock_guard<FairMutex> lock(mutex_);
  response.success = clock_.paused();
  if (response.success) {
    clock_.step();
    response.message = "advancing by " + shown(1 / rate_) + " s";
  } else {
    response.message = "not paused: call ~pause with data: true first";
  }
  return true;
}

bool Node::onReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  const std::lock_guard<FairMutex> lock(mutex_);
  response.success = true;
  response.message = reset();
  return true;
}

void Node::onSpeed(const std_msgs::Float64& message) {
  const std::lock_guard<FairMutex> lock(mutex_);
  if (!std::isfinite(message.data)) {
    refused("speed " + shown(message.data) + " refused: a finite number is allowed");
    return;
  }
  const double cost = steppingCost();
  if (cost * std::abs(message.data) > kMostLoad) {
    refused("speed " + shown(message.data) + " refused: the steps of this scene cost " + shown(cost) +
            " CPU s per simulated s; up to " + shown(kMostLoad / cost) + " is allowed here");
    return;
  }
  clock_.setSpeed(message.data);
  refused_.clear();
}

void Node::onSeek(const std_msgs::Float64& message) {
  const std::lock_guard<FairMutex> lock(mutex_);
  if (change_ && change_->from_start && !change_->all && std::isfinite(message.data)) {
    change_->seek = message.data;  // else it would be undone by the start at t = 0
    return;
  }
  seek(message.data);
}

void Node::seek(double time) {
  if (!std::isfinite(time)) {
    refused("seek to " + shown(time) + " refused: a finite time is allowed");
    return;
  }
  double total = 0;
  for (const auto& body : bodies_) {
    const MotionSetup& setup = body->motion().setup();
    const double steps = body->motion().stepsTo(time);
    if (steps > kMostSteps) {
      refused("seek to " + shown(time) + " s refused: body " + body->name() + " under " + setup.method +
              " would take " + shown(std::isfinite(steps) ? steps : std::abs(time) / *setup.step) + " steps of " +
              shown(*setup.step) + " s; at most " + shown(kMostSteps) + " are allowed");
      return;
    }
    total += steps;
  }
  seeker_.cancel();
  if (total <= kBackgroundSeekSteps) {
    for (const auto& body : bodies_) {
      try {
        body->motion().at(time);
      } catch (const std::runtime_error& error) {  // range_error, NoConvergence
        refused("seek to " + shown(time) + " s refused: body " + body->name() + ": " + error.what() + " there");
        return;
      }
    }
    jumpTo(time);
    return;
  }
  ROS_INFO("seek to %g s takes %.3g steps; playing on meanwhile", time, total);
  std::vector<Motion> motions;
  for (const auto& body : bodies_) motions.push_back(body->motion());
  seeker_.start(std::move(motions), time);
}

void Node::diagnoseTicks(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const Punctuality p = pacer_.takePunctuality();
  const bool late = p.ticks > 0 && p.rate < 0.9 * rate_ && pacer_.mode() != Pacer::Mode::foreign_clock;
  status.summary(late ? diagnostic_msgs::DiagnosticStatus::WARN : diagnostic_msgs::DiagnosticStatus::OK,
                 late ? "slower than asked" : "on time");
  status.addf("rate asked [Hz]", "%g", rate_);
  status.addf("rate [Hz]", "%.6g", p.rate);
  status.addf("jitter, standard deviation [s]", "%.3g", p.jitter);
  status.addf("lateness, mean [s]", "%.3g", p.mean_lateness);
  status.addf("lateness, worst [s]", "%.3g", p.worst);
  status.add("paused", clock_.paused() ? "yes" : "no");
  status.addf("speed", "%g", clock_.speed());
}

}  // namespace poinsot::node
