#include "poinsot/ros/node.h"

#include <ros/spinner.h>
#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "poinsot/cost/cpu_time.h"
#include "poinsot/ros/names.h"

namespace poinsot::node {
namespace {

using visualization_msgs::MarkerArray;

constexpr int kMarkerQueue = 100;
constexpr int kControlQueue = 100;
const ros::WallDuration kResendAfter(2);
const ros::WallDuration kPatienceForClock(3);
constexpr double kMostSeekSteps = 1e9;
constexpr double kBackgroundSeekSteps = 2e4;  // about 2 ms: more is not done between two ticks
constexpr double kMostTickSteps = 5e6;        // about 0.4 s: beyond it the clock has jumped, or runs too fast to follow
constexpr double kMostLoad = 0.8;             // of one core, for what a speed may ask of the steppers
constexpr double kAstray = 0.1;               // rad from the truth: /diagnostics warns
constexpr double kCoarseShare = 0.1;          // of a tick: where doubles lie further apart, t is seen to jump

Pacer::Mode pacing(bool publish_clock) {
  if (publish_clock) return Pacer::Mode::own_clock;
  return ros::Time::isSimTime() ? Pacer::Mode::foreign_clock : Pacer::Mode::wall;
}

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

}  // namespace

Node::Node(const Parameters& parameters, const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
    : clock_(1 / parameters.rate),
      pacer_(pacing(parameters.publish_clock), parameters.rate),
      rate_(parameters.rate),
      handle_(handle),
      private_handle_(private_handle),
      diagnostics_(handle, private_handle) {
  for (const std::string& warning : parameters.scene.warnings) ROS_WARN("%s", warning.c_str());
  for (const std::string& choice : parameters.choices) ROS_INFO("%s", choice.c_str());
  if (parameters.publish_clock) {
    if (!ros::Time::isSimTime()) ROS_WARN("~publish_clock is on, but /use_sim_time is not set: nobody follows /clock");
    clock_publisher_ = handle_.advertise<rosgraph_msgs::Clock>(names::kClock, 10);
  }
  markers_publisher_ = handle_.advertise<MarkerArray>(names::kMarkers, kMarkerQueue);
  markers_static_publisher_ = handle_.advertise<MarkerArray>(
      names::kMarkersStatic, 1,
      [this](const ros::SingleSubscriberPublisher&) {
        const std::lock_guard<FairMutex> lock(mutex_);
        resend_static_at_ = ros::SteadyTime::now() + kResendAfter;
      },
      ros::SubscriberStatusCallback(), ros::VoidConstPtr(), true);

  diagnostics_.setHardwareID("none");
  diagnostics_.add("ticks", this, &Node::diagnoseTicks);
  for (const scene::Body& body : parameters.scene.bodies) {
    bodies_.push_back(std::make_unique<Body>(body, parameters.frame_prefix, rate_, handle_));
    const Body* added = bodies_.back().get();
    some_body_steps_ = some_body_steps_ || !added->motion().inClosedForm();
    diagnostics_.add("body " + body.name, [added](diagnostic_updater::DiagnosticStatusWrapper& status) {
      const MotionSetup& setup = added->motion().setup();
      const std::string step = setup.step ? ", step " + shown(*setup.step) + " s" : "";
      const BodyPicture::Figures figures = added->figures();
      const bool astray = figures.attitude_error > kAstray;
      status.summary(astray ? diagnostic_msgs::DiagnosticStatus::WARN : diagnostic_msgs::DiagnosticStatus::OK,
                     setup.method + step + (astray ? ": " + shown(figures.attitude_error) + " rad astray" : ""));
      status.addf("simulation time [s]", "%.9g", added->state().time);
      if (!added->motion().torques()) status.addf("attitude error [rad]", "%.3g", figures.attitude_error);
      status.addf("energy [J]", "%.6g", figures.kinetic_energy);
      status.addf("energy drift", "%.3g", figures.energy_drift);
      status.addf("momentum drift", "%.3g", added->momentumDrift());
      status.addf("cost [CPU s per simulated s]", "%.3g", figures.cost);
    });
  }

  if (steppingCost() > kMostLoad) {
    throw ParameterError("the steps of this scene cost " + shown(steppingCost()) +
                         " CPU s per simulated s here, which cannot be played in real time; at most " +
                         shown(kMostLoad) + " can: take larger steps, or " + kClosedForm + ", which has none");
  }

  services_ = {private_handle_.advertiseService(names::kPause, &Node::onPause, this),
               private_handle_.advertiseService(names::kStep, &Node::onStep, this),
               private_handle_.advertiseService(names::kReset, &Node::onReset, this)};
  subscribers_ = {private_handle_.subscribe(names::kSpeed, kControlQueue, &Node::onSpeed, this),
                  private_handle_.subscribe(names::kSeek, kControlQueue, &Node::onSeek, this)};
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
  if (pacer_.mode() == Pacer::Mode::foreign_clock && !ros::Time::waitForValid(kPatienceForClock)) {
    ROS_WARN("/use_sim_time is set, but nobody publishes /clock: nothing moves until somebody does");
  }
  while (pacer_.wait()) {
    const std::lock_guard<FairMutex> lock(mutex_);
    tick();
    diagnostics_.update();
  }
  spinner.stop();
}

void Node::tick() {
  const ros::Time now = pacer_.stamp();
  if (now.isZero()) return;  // a foreign clock that has not begun
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
  } else if (stepsTo(clock_.timeAt(now)) > kMostTickSteps) {
    ROS_WARN_THROTTLE(
        1,
        "ROS time is %g s further than at the last tick, too far to step at once: t goes on from where it "
        "was, in a new segment",
        (now - clock_.stamp()).toSec());
    clock_.restartStamps();
  }
  resendStaticMarkers();
  takeFinishedSeek();
  const std::optional<Tick> tick = clock_.tick(now);
  if (!tick) return;

  transforms_.clear();
  cost::threadCpuTime();  // the first call after a sleep is slow, which the first body would be charged with
  for (const auto& body : bodies_) {
    body->move(*tick);
    body->appendTransforms(tick->stamp, transforms_);
  }
  broadcaster_.sendTransform(transforms_);
  for (const auto& body : bodies_) body->publish(*tick);
  publishMarkers(*tick);
}

double Node::stepsTo(double time) const {
  double sum = 0;
  for (const auto& body : bodies_) sum += body->motion().stepsTo(time);
  return sum;
}

void Node::publishStatic() {
  const ros::Time stamp = pacer_.stamp();
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const auto& body : bodies_) {
    body->appendStaticTransforms(stamp, transforms);
    body->publishDescription();
  }
  // One message for all: whoever replays a bag gets the last one of a latched topic only.
  static_broadcaster_.sendTransform(transforms);
  markers_static_publisher_.publish(staticMarkers());
}

MarkerArray Node::staticMarkers() const {
  MarkerArray markers = clearedMarkers();
  for (const auto& body : bodies_) body->picture().appendStatic(markers);
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
  const bool watched = markers_publisher_.getNumSubscribers() > 0;
  if (watched) {
    MarkerArray markers = markers_watched_ ? MarkerArray() : clearedMarkers();
    for (const auto& body : bodies_) {
      body->picture().appendMoving(tick, body->motion(), body->state(), markers);
      if (some_body_steps_) body->picture().appendFigures(tick, body->figures(), markers);
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
    ROS_ERROR("seek refused: %s there", error.what());
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
}

bool Node::onPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
  const std::lock_guard<FairMutex> lock(mutex_);
  clock_.pause(request.data);
  response.success = true;
  response.message = std::string(request.data ? "paused" : "playing") + " at t = " + shown(clock_.time()) + " s";
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
  seeker_.cancel();
  clock_.jumpTo(0);
  response.success = true;
  response.message = "back to t = 0";
  return true;
}

void Node::onSpeed(const std_msgs::Float64& message) {
  const std::lock_guard<FairMutex> lock(mutex_);
  if (!std::isfinite(message.data)) {
    ROS_ERROR("speed %g refused: a finite number is allowed", message.data);
    return;
  }
  const double cost = steppingCost();
  if (cost * std::abs(message.data) > kMostLoad) {
    ROS_ERROR("speed %g refused: the steps of this scene cost %g CPU s per simulated s; up to %.3g is allowed here",
              message.data, cost, kMostLoad / cost);
    return;
  }
  clock_.setSpeed(message.data);
}

void Node::onSeek(const std_msgs::Float64& message) {
  const std::lock_guard<FairMutex> lock(mutex_);
  const double time = message.data;
  if (!std::isfinite(time)) {
    ROS_ERROR("seek to %g refused: a finite time is allowed", time);
    return;
  }
  double total = 0;
  for (const auto& body : bodies_) {
    const MotionSetup& setup = body->motion().setup();
    const double steps = body->motion().stepsTo(time);
    if (steps > kMostSeekSteps) {
      ROS_ERROR("seek to %g s refused: body %s under %s would take %.3g steps of %g s; at most %g are allowed", time,
                body->name().c_str(), setup.method.c_str(), std::isfinite(steps) ? steps : std::abs(time) / *setup.step,
                *setup.step, kMostSeekSteps);
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
        ROS_ERROR("seek to %g s refused: body %s: %s there", time, body->name().c_str(), error.what());
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
