// What changes the bodies while they play: another scene, another method, another spin, and taking hold of one.
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>

#include "poinsot/ros/conversions.h"
#include "poinsot/ros/limits.h"
#include "poinsot/ros/meshes.h"
#include "poinsot/ros/names.h"
#include "poinsot/ros/node.h"
#include "poinsot/ros/number_text.h"
#include "poinsot/ros/requests_text.h"
#include "poinsot/ros/scene_list.h"
#include "poinsot/scene/changes.h"
#include "poinsot/scene/reader.h"
#include "poinsot/view/flips.h"
#include "poinsot/view/grasp.h"

namespace poinsot::node {
namespace {

constexpr double kClick = 0.005;            // m: a hand that moves less has not led anything
constexpr std::size_t kMostGrips = 16;      // bodies beyond have none
constexpr std::size_t kGripsEachTick = 4;   // with more they are placed more rarely
constexpr double kBesideSeparatrix = 3e-7;  // k': some last bits of E and |L|²
const ros::WallDuration kHoldForgotten(3);  // a viewer that died lets go
const ros::WallDuration kPreviewPause(0.05);
const ros::WallDuration kResendAfterScene(0.5);

bool sameStart(const scene::Body& a, const scene::Body& b) {
  const bool same_place = a.translation.has_value() == b.translation.has_value() &&
                          (!a.translation || (a.translation->position == b.translation->position &&
                                              a.translation->velocity == b.translation->velocity));
  return same_place && a.omega_body == b.omega_body && a.attitude.coeffs() == b.attitude.coeffs();
}

/** Does what a service was asked for; `act` throws what is wrong, which is answered and told by `refuse`. */
template <class Response, class Act, class Refuse>
bool answered(Response& response, const Act& act, const Refuse& refuse) {
  try {
    act();
    response.success = true;
  } catch (const std::exception& error) {
    refuse(error.what());
    response.success = false;
    response.message = error.what();
  }
  return true;
}

const char* const kRestsText = "it is at rest, and has no spin to go by; ~set_spin and ~reset give it one";

}  // namespace

std::size_t Node::indexOf(const std::string& body) const {
  std::string names;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i]->name() == body) return i;
    names += (i ? ", " : "") + bodies_[i]->name();
  }
  throw scene::Error("there is no body \"" + body + "\"; allowed: " + names);
}

void Node::refused(const std::string& what) {
  ROS_ERROR("%s", what.c_str());
  refused_ = what;
}

// Working out.

Node::Change Node::wanted() const {
  if (change_) return *change_;
  Change out;
  out.scene = scene_;
  out.start_scene = start_scene_;
  out.name = scene_name_;
  out.file = scene_file_;
  return out;
}

Node::Change Node::wantedOfPresentScene() const {
  Change out = wanted();
  if (out.all) throw scene::Error("another scene is being made ready; allowed: the same when it plays");
  return out;
}

void Node::ask(Change change) {
  // If it is refused, so is all that is done with it.
  if (change_ && !change.all && !change.redraw) change.what = withAll(change_->what, change.what);
  change_ = std::move(change);
  if (rebuild_.busy()) {
    change_is_newer_ = true;
    rebuild_.cancel();
  } else {
    startRebuild();
  }
}

void Node::startRebuild() {
  Rebuild::Order order;
  order.scene = change_->scene;
  if (change_->all) {
    for (std::size_t i = 0; i < order.scene.bodies.size(); ++i) order.bodies.push_back(i);
  } else {
    order.bodies.assign(change_->bodies.begin(), change_->bodies.end());
    for (const std::size_t i : order.bodies) {
      order.keep.push_back(change_->redraw ? std::nullopt : std::make_optional(bodies_[i]->picture().frame()));
    }
  }
  order.time = comingTime();
  order.rate = rate_;
  order.frame_prefix = frame_prefix_;
  rebuild_.start(std::move(order), handle_);
}

double Node::comingTime() const {
  return change_->from_start ? 0 : clock_.comingTime();
}

void Node::takeFinishedRebuild() {
  std::optional<Rebuild::Result> made;
  std::string problem;
  try {
    made = rebuild_.poll();
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (!made && problem.empty()) return;
  if (change_is_newer_) {
    change_is_newer_ = false;
    startRebuild();
    return;
  }
  if (made) {
    double cost = 0;
    for (const auto& body : made->bodies) cost += body->cost().steppingCost();
    for (std::size_t i = 0; i < bodies_.size() && !change_->all; ++i) {
      if (change_->bodies.count(i) == 0) cost += bodies_[i]->cost().steppingCost();
    }
    if (cost * std::abs(clock_.speed()) > kMostLoad) {
      problem = "its steps cost " + shown(cost) + " CPU s per simulated s here, and at speed " + shown(clock_.speed()) +
                " at most " + shown(kMostLoad / std::abs(clock_.speed())) +
                " is allowed: take larger steps or a lower speed";
    }
  }
  if (!problem.empty()) {
    if (change_->reset) clock_.jumpTo(0);
    const std::optional<double> sought = change_->seek;
    const std::string what = joined(change_->what);
    change_.reset();
    if (sought) seek(*sought);
    refused(what + " refused: " + problem);
    endHold();
    return;
  }
  // t has gone on meanwhile, and may have been sent far away.
  double steps = 0;
  for (const auto& body : made->bodies) steps += body->motion().stepsTo(comingTime());
  if (steps > kMostTickSteps) {
    rebuild_.goOn(std::move(*made), comingTime());
    return;
  }
  exchange(std::move(*made));
}

void Node::exchange(Rebuild::Result&& made) {
  for (const std::string& said : made.said) ROS_INFO("%s", said.c_str());
  const std::optional<double> sought =
      seeker_.busy() && !change_->from_start ? std::make_optional(seeker_.time()) : change_->seek;
  seeker_.cancel();
  if (change_->all) {
    for (const auto& body : bodies_) diagnostics_.removeByName("body " + body->name());
    grip_->removeAll();
    bodies_ = std::move(made.bodies);
    for (const auto& body : bodies_) diagnoseBody(body->name());
    resend_static_at_ = ros::SteadyTime::now() + kResendAfterScene;  // its frames are new to everybody
  } else {
    for (std::size_t k = 0; k < made.indices.size(); ++k) {
      made.bodies[k]->stand(comingTime());
      bodies_[made.indices[k]] = std::move(made.bodies[k]);
    }
  }
  if (change_->all) {
    // What the old scene had sent is not for who comes now, and who is there is to see no more of it.
    transforms_.transforms.clear();
    last_tick_.reset();
    markers_publisher_.publish(clearedMarkers());
  }
  scene_ = std::move(made.scene);
  start_scene_ = std::move(change_->start_scene);
  scene_name_ = change_->name;
  scene_file_ = change_->file;
  some_body_steps_ =
      std::any_of(bodies_.begin(), bodies_.end(), [](const auto& body) { return !body->motion().inClosedForm(); });
  if (change_->from_start) {
    clock_.jumpTo(0);
  } else {
    clock_.beginSegment();
  }
  change_.reset();
  refused_.clear();
  if (hold_) {
    clock_.pause(hold_->was_paused);
    hold_.reset();
  }
  publishStatic();
  markers_watched_ = false;   // what moves begins anew as well
  if (sought) seek(*sought);  // with what moves now
}

// What is asked for.

bool Node::onLoadScene(LoadScene::Request& request, LoadScene::Response& response) {
  const auto act = [&] {
    std::string wish = request.scene;
    if (wish.empty()) {
      const std::lock_guard<FairMutex> lock(mutex_);
      wish = scene_file_;
      if (wish.empty()) throw scene::Error("the present scene came without a file; allowed: a name or a path");
    }
    const std::string file = sceneFile(wish);
    Change change;
    change.scene = scene::readFile(file);
    requireMeshes(change.scene);
    checkPrefix(frame_prefix_, change.scene);
    for (const std::string& warning : change.scene.warnings) ROS_WARN("%s", warning.c_str());
    change.start_scene = change.scene;
    change.name = sceneName(file);
    change.file = file;
    change.all = change.from_start = true;
    change.what = {"scene " + change.name};
    response.message = change.what.front() + " is being made ready";
    const std::lock_guard<FairMutex> lock(mutex_);
    endHold();
    ask(std::move(change));
  };
  // A file may take its time: it is read without the lock.
  return answered(response, act, [this](const std::string& what) {
    const std::lock_guard<FairMutex> lock(mutex_);
    refused(what);
  });
}

bool Node::onSetMethod(SetMethod::Request& request, SetMethod::Response& response) {
  const std::lock_guard<FairMutex> lock(mutex_);
  const auto act = [&] {
    Change change = wantedOfPresentScene();
    const std::size_t i = indexOf(request.body);
    std::vector<std::string> warnings;
    scene::Body body = scene::withMethod(change.scene.bodies[i], request.method,
                                         request.step == 0 ? std::nullopt : std::make_optional(request.step), warnings);
    response.message = request.body + ": " + body.method;
    if (body.step) {
      const double time = change.from_start ? 0 : clock_.comingTime(), steps = std::abs(time) / *body.step;
      if (!(steps <= kMostSteps)) throw scene::Error(tooManySteps(request.body, time, steps, *body.step));
      response.message += " with a step of " + shown(*body.step) + " s";
    }
    for (const std::string& warning : warnings) {
      ROS_WARN("%s", warning.c_str());
      response.message += "; " + warning;
    }
    // What ~reset brings back is the start; the method stays.
    change.scene.bodies[i] = std::move(body);
    change.bodies.insert(i);
    change.what = {"method " + request.method + " of " + request.body};
    ask(std::move(change));
  };
  return answered(response, act, [this](const std::string& what) { refused(what); });
}

bool Node::onSetSpin(SetSpin::Request& request, SetSpin::Response& response) {
  const std::lock_guard<FairMutex> lock(mutex_);
  const geometry_msgs::Vector3& omega = request.omega_body;
  return answered(
      response,
      [&] {
        askForSpin(indexOf(request.body), {omega.x, omega.y, omega.z});
      },
      [this](const std::string& what) { refused(what); });
}

void Node::askForSpin(std::size_t i, const Eigen::Vector3d& omega_body) {
  Change change = wantedOfPresentScene();
  change.scene.bodies[i] = scene::withSpin(change.scene.bodies[i], bodies_[i]->state(), omega_body);
  change.bodies.insert(i);
  change.from_start = true;
  change.what = {"spin of " + bodies_[i]->name()};
  ask(std::move(change));
}

std::string Node::reset() {
  endHold();
  seeker_.cancel();
  Change change = wanted();
  bool changed = false;
  for (std::size_t i = 0; i < change.scene.bodies.size() && !change.all; ++i) {
    if (sameStart(change.scene.bodies[i], change.start_scene.bodies[i])) continue;
    change.scene.bodies[i] = scene::withStartOf(change.scene.bodies[i], change.start_scene.bodies[i]);
    change.bodies.insert(i);
    changed = true;
  }
  // What is being worked out for a t far away is wanted for t = 0 now.
  const bool pending = change_ && !change_->all;
  if (!changed && !pending) {
    clock_.jumpTo(0);
    refused_.clear();
    return "back to t = 0";
  }
  change.from_start = change.reset = true;
  change.redraw = change.redraw || changed;
  change.seek.reset();
  change.what = {"reset"};
  ask(std::move(change));
  return changed ? "going back to t = 0 and the scene's own spins" : "going back to t = 0";
}

// Taking hold.

void Node::onViewpoint(const geometry_msgs::PointStamped& message) {
  const Eigen::Vector3d eye(message.point.x, message.point.y, message.point.z);
  const std::lock_guard<FairMutex> lock(mutex_);
  if (message.header.frame_id != names::kWorld || !eye.allFinite()) {
    ROS_WARN_THROTTLE(10, "a viewpoint in frame %s is of no use: finite, in frame %s is",
                      message.header.frame_id.c_str(), names::kWorld);
    return;
  }
  eye_ = eye;
}

MovingBody& Node::drawn(std::size_t body) const {
  if (hold_ && hold_->body == body && hold_->preview) return *hold_->preview;
  return *bodies_[body];
}

Eigen::Vector3d Node::omegaPoint(const MovingBody& body) const {
  return body.picture().scale().metres_per_radian_per_second * body.state().omega_body;
}

void Node::takeTouches() {
  for (const Touch& touch : grip_->take()) {
    try {
      touched(touch);
    } catch (const std::exception& error) {
      refused(error.what());
    }
  }
  if (hold_ && !hold_->let_go && ros::SteadyTime::now() - hold_->touched > kHoldForgotten) {
    ROS_WARN("whoever held %s is gone: it goes on as it was", bodies_[hold_->body]->name().c_str());
    endHold();
  }
}

void Node::touched(const Touch& touch) {
  switch (touch.kind) {
    case Touch::Kind::reset:
      reset();
      return;
    case Touch::Kind::keep:
      keep_ = touch.keep;
      grip_->showKept(keep_);
      return;
    case Touch::Kind::press:
      press(indexOf(touch.body));
      return;
    case Touch::Kind::lead:
      lead(touch);
      return;
    case Touch::Kind::hold:
      if (hold_ && bodies_[hold_->body]->name() == touch.body) hold_->touched = ros::SteadyTime::now();
      return;
    case Touch::Kind::let_go:
      if (hold_ && bodies_[hold_->body]->name() == touch.body) letGo();
      return;
    case Touch::Kind::axis:
    case Touch::Kind::near:
    case Touch::Kind::separatrix:
      choose(touch);
      return;
  }
}

void Node::press(std::size_t body) {
  if (hold_ && hold_->body == body) {
    if (!hold_->let_go) return;
  }
  endHold();
  hold_ = Hold();  // clang 14 takes no emplace(): where the optional is declared, Hold has no constructor yet
  hold_->body = body;
  hold_->was_paused = clock_.paused();
  hold_->taken_at = omegaPoint(*bodies_[body]);
  hold_->touched = ros::SteadyTime::now();
  clock_.pause(true);
}

void Node::lead(const Touch& touch) {
  const std::size_t i = indexOf(touch.body);
  const MovingBody& body = *bodies_[i];
  if (touch.frame != body.frames().model) {
    throw scene::Error("grip of " + touch.body + ": a place in frame \"" + touch.frame + "\"; allowed: frame " +
                       body.frames().model);
  }
  if (body.state().omega_body.isZero(0)) throw scene::Error("grip of " + touch.body + ": " + kRestsText);
  const double metres = body.picture().scale().metres_per_radian_per_second;
  const PrincipalInertia& inertia = body.motion().setup().inertia;
  const Eigen::Vector3d semi_axes =
      metres * view::keptSemiAxes(inertia.moments(), inertia.toPrincipal(body.state().omega_body), keep_);
  std::optional<Eigen::Vector3d> place;
  if (eye_ && viewpoint_subscriber_.getNumPublishers() > 0) {  // else whoever looked from there is gone
    const view::Layout& layout = body.picture().layout();
    const Eigen::Vector3d eye = layout.model_orientation.conjugate() * (*eye_ - layout.model_centre);
    place = view::pointInSight(semi_axes, inertia.toPrincipal(eye), inertia.toPrincipal(touch.point));
  } else {
    place = view::pointTowards(semi_axes, inertia.toPrincipal(touch.point));
  }
  if (!place) {
    throw scene::Error("grip of " + touch.body + ": (" + shown(touch.point.x()) + ", " + shown(touch.point.y()) + ", " +
                       shown(touch.point.z()) +
                       ") m is no place to lead Omega to; allowed: finite places off the centre");
  }
  if (!hold_ || hold_->body != i || hold_->let_go) press(i);
  hold_->touched = ros::SteadyTime::now();
  // The tick that stopped the body has moved it once more: the hand may have seen either place.
  const auto near = [&](const Eigen::Vector3d& seen) { return (touch.point - seen).stableNorm() < kClick; };
  if (!hold_->led && (near(hold_->taken_at) || near(omegaPoint(body)))) return;
  hold_->led = true;
  hold_->omega_body = inertia.toBody(*place) / metres;
  scene::Body start = scene::withSpin(scene_.bodies[i], body.state(), hold_->omega_body);
  if (start.effects.empty()) {
    start.method = kClosedForm;  // only its start is looked at
    start.step.reset();
  }
  if (!hold_->preview) markers_watched_ = false;  // the trail and the words are those of the spin before
  hold_->preview = std::make_unique<MovingBody>(start, frame_prefix_, true, body.picture().frame());
  hold_->preview_is_new = true;
}

void Node::letGo() {
  if (!hold_->led) {
    endHold();
    return;
  }
  try {
    askForSpin(hold_->body, hold_->omega_body);
    hold_->let_go = true;
  } catch (const std::exception&) {
    endHold();
    throw;
  }
}

void Node::endHold() {
  if (!hold_) return;
  const bool has_preview = hold_->preview != nullptr;
  clock_.pause(hold_->was_paused);
  hold_.reset();
  if (!has_preview) return;
  markers_static_publisher_.publish(staticMarkers());
  markers_watched_ = false;
}

void Node::choose(const Touch& touch) {
  const std::size_t i = indexOf(touch.body);
  endHold();
  const PrincipalInertia& inertia = bodies_[i]->motion().setup().inertia;
  const Eigen::Vector3d omega = inertia.toPrincipal(bodies_[i]->state().omega_body);
  if (omega.isZero(0)) throw scene::Error("spin of " + touch.body + ": " + kRestsText);
  Eigen::Vector3d chosen;
  if (touch.kind == Touch::Kind::axis) {
    chosen = view::axisSpin(inertia.moments(), omega, keep_, touch.axis);
  } else if (touch.kind == Touch::Kind::near) {
    chosen = view::nearAxis(inertia.moments(), omega, keep_, touch.axis);
  } else {
    try {
      chosen = view::onSeparatrix(inertia.moments(), omega, keep_);
    } catch (const std::invalid_argument& error) {
      throw scene::Error("spin of " + touch.body + ": " + error.what() + "; allowed: spins about or near an axis");
    }
  }
  askForSpin(i, inertia.toBody(chosen));
}

bool Node::publishPreview() {
  if (!hold_ || !hold_->preview_is_new || ros::SteadyTime::now() - hold_->preview_sent < kPreviewPause) return false;
  hold_->preview_is_new = false;
  hold_->preview_sent = ros::SteadyTime::now();
  markers_static_publisher_.publish(staticMarkers());
  return true;
}

void Node::placeGrips() {
  if (!grip_->watched()) return;
  const std::size_t pause = (bodies_.size() + kGripsEachTick - 1) / kGripsEachTick;
  if (++ticks_since_grips_ < pause && !hold_) return;
  ticks_since_grips_ = 0;
  for (std::size_t i = 0; i < std::min(bodies_.size(), kMostGrips); ++i) {
    const MovingBody& body = drawn(i);
    if (body.state().omega_body.isZero(0)) {
      grip_->remove(body.name());
    } else {
      grip_->place(body.name(), body.frames().model, omegaPoint(body));
    }
  }
  grip_->apply();
}

// What is said of it.

void Node::publishStatus() {
  if (status_publisher_.getNumSubscribers() == 0) return;
  const std::lock_guard<FairMutex> lock(mutex_);
  NodeStatus out;
  out.header.stamp = clock_.stamp();
  out.scene = scene_name_;
  out.scene_file = scene_file_;
  out.scenes = scene_names_;
  out.time = clock_.time();
  out.segment = clock_.segment();
  out.paused = clock_.paused();
  out.speed = clock_.speed();
  out.rate = rate_;
  out.busy = change_ ? joined(change_->what) : seeker_.busy() ? "seek" : "";
  out.refused = refused_;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Body& body = *bodies_[i];
    BodyStatus b;
    b.name = body.name();
    b.method = body.motion().setup().method;
    b.step = body.motion().setup().step.value_or(std::numeric_limits<double>::quiet_NaN());
    b.methods = scene::methodsFor(scene_.bodies[i]);
    const MovingBody& seen = drawn(i);
    if (const ClosedForm* exact = seen.motion().closedForm()) {
      b.regime = seen.picture().regime();
      if (exact->separatrixDistance() > 0 && exact->separatrixDistance() < kBesideSeparatrix) {
        b.regime = "on the separatrix, to rounding";
      }
      const view::Flips flips = view::flipsOf(*exact, seen.state().time, clock_.speed());
      b.flips = flips.flips;
      b.flips_since_start = flips.since_start;
      b.time_to_next_flip = flips.to_next;
    } else {
      b.regime = "under torque";
      b.time_to_next_flip = std::numeric_limits<double>::quiet_NaN();
    }
    out.bodies.push_back(b);
  }
  status_publisher_.publish(out);
}

}  // namespace poinsot::node
