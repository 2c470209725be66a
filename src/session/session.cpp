#include "poinsot/session/session.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "limits.h"
#include "poinsot/scene/changes.h"

namespace poinsot::session {
namespace {

constexpr double kCoarseShare = 0.1;  // of a tick: where doubles lie further apart, t is seen to jump

}  // namespace

Session::Session(const Options& options, const NamedScene& scene, Built&& built, Job& job, Listener& listener)
    : options_(options),
      job_(job),
      listener_(listener),
      clock_(1 / options.rate),
      bodies_(std::move(built.bodies)),
      playing_(scene),
      start_scene_(scene.scene) {}

Body& Session::drawn(std::size_t i) const {
  return preview_ && drag_.isOn(bodies_[i]->name()) ? *preview_ : *bodies_[i];
}

void Session::beginNextRound(Nanoseconds stamp) {
  const std::optional<double>& loop = playing_.scene.loop;
  if (!loop || clock_.paused()) return;
  const double next = clock_.nextTime(stamp);
  if (clock_.speed() > 0 && next >= *loop) clock_.jumpTo(0);
  // Steppers may take long to get to the end.
  if (clock_.speed() < 0 && next < 0 && !seek_ && seek(*loop).refusal) clock_.pause(true);
}

std::optional<Tick> Session::tick(Nanoseconds stamp) {
  if (clock_.jumpedBack(stamp)) {
    clock_.restartStamps();
    listener_.stampsJumpedBack();
  } else if (!std::isfinite(clock_.nextTime(stamp))) {
    listener_.timeLeftTheRange(clock_.time(), clock_.speed());
    clock_.pause(true);
    clock_.restartStamps();
  } else if (stepsTo(bodies_, clock_.nextTime(stamp)) > kMostTickSteps) {
    listener_.stampsJumpedAhead(toSeconds(stamp - clock_.stamp()));
    clock_.restartStamps();
  }
  beginNextRound(stamp);
  const std::optional<Tick> tick = clock_.tick(stamp);
  if (tick) {
    for (const auto& body : bodies_) body->move(*tick);
  }
  return tick;
}

void Session::ask(const Request& request, const Reply& reply) {
  Answer answer;
  if (const auto* pausing = std::get_if<Pause>(&request)) {
    answer = pause(pausing->paused);
  } else if (std::holds_alternative<Step>(request)) {
    answer = step();
  } else if (const auto* speed = std::get_if<SetSpeed>(&request)) {
    answer = setSpeed(*speed);
  } else if (const auto* sought = std::get_if<Seek>(&request)) {
    const bool waits = !loading() && std::isfinite(sought->time);
    if (waits && !queue_.empty()) return enqueue(request, reply);
    if (waits && draft_ && draft_->from_start) {
      draft_->seek = sought->time;  // before the start at t = 0 it would be undone by that
    } else {
      answer = seek(sought->time);
    }
  } else if (std::holds_alternative<Reset>(request)) {
    endDrag();
    stopSeeking();
    const bool changes_bodies = draft_ || !queue_.empty() || startsDiffer(playing_.scene, start_scene_);
    if (changes_bodies && !loading()) return enqueue(request, reply);
    answer = resetNow();
  } else {
    return enqueue(request, reply);
  }
  if (reply) reply(answer);
}

Answer Session::pause(bool paused) {
  if (drag_.state() != SpinDrag::State::free) {
    drag_.pauseAfterwards(paused);
  } else {
    clock_.pause(paused);
  }
  refusal_.reset();
  return {};
}

Answer Session::step() {
  Answer out;
  if (clock_.paused()) {
    clock_.step();
  } else {
    out.refusal = refusalOf(Reason::not_paused, {Step{}});  // no fault to be shown for long: the answer is enough
  }
  return out;
}

Answer Session::setSpeed(const SetSpeed& request) {
  if (!std::isfinite(request.speed)) return refuse(refusalOf(Reason::not_finite, {request}));
  const double cost = steppingCost();
  if (cost * std::abs(request.speed) > kMostLoad) {
    Refusal out = refusalOf(Reason::too_fast, {request});
    out.figure = cost;
    out.limit = kMostLoad / cost;
    return refuse(out);
  }
  clock_.setSpeed(request.speed);
  refusal_.reset();
  return {};
}

Answer Session::resetNow() {
  clock_.jumpTo(0);
  refusal_.reset();
  return {};
}

Answer Session::seek(double time) {
  if (!std::isfinite(time)) return refuse(refusalOf(Reason::not_finite, {Seek{time}}));
  for (const auto& body : bodies_) {
    const double steps = body->motion().stepsTo(time);
    if (!(steps > kMostSteps)) continue;
    const MotionSetup& setup = body->motion().setup();
    Refusal out = refusalOf(Reason::too_many_steps, {Seek{time}});
    out.body = body->name();
    out.method = setup.method;
    out.step = *setup.step;
    out.figure = std::isfinite(steps) ? steps : std::abs(time) / *setup.step;
    out.limit = kMostSteps;
    return refuse(out);
  }
  const double steps = stepsTo(bodies_, time);
  stopSeeking();
  if (steps > kMostInlineSteps) {
    listener_.seeksFar(time, steps);
    seek_ = time;
    startNext();
    return {};
  }
  for (const auto& body : bodies_) {
    try {
      body->motion().at(time);
    } catch (const std::runtime_error& error) {  // range_error, NoConvergence
      Refusal out = refusalOf(Reason::no_state, {Seek{time}}, error.what());
      out.body = body->name();
      return refuse(out);
    }
  }
  jumpTo(time);
  return {};
}

void Session::jumpTo(double time) {
  const double spacing = std::nextafter(std::abs(time), HUGE_VAL) - std::abs(time);
  if (spacing > kCoarseShare / options_.rate) listener_.timeIsCoarse(time, spacing);
  clock_.jumpTo(time);
  refusal_.reset();
}

Answer Session::refuse(Refusal refusal) {
  listener_.refused(refusal);
  Answer out;
  out.refusal = refusal_ = std::move(refusal);
  return out;
}

Answer Session::refuse(const Request& request, const std::string& detail) {
  return refuse(refusalOf(Reason::bad_request, {request}, detail));
}

std::optional<Refusal> Session::tooCostly(const Built& built) const {
  double cost = session::steppingCost(built.bodies);
  for (std::size_t i = 0; i < bodies_.size() && !draft_->all; ++i) {
    if (draft_->bodies.count(i) == 0) cost += bodies_[i]->steppingCost();
  }
  if (!(cost * std::abs(clock_.speed()) > kMostLoad)) return std::nullopt;
  Refusal out = refusalOf(Reason::too_fast, {});
  out.figure = cost;
  out.limit = kMostLoad / std::abs(clock_.speed());
  out.speed = clock_.speed();
  return out;
}

Status Session::status() const {
  Status out;
  out.scene = playing_.name;
  out.file = playing_.file;
  out.time = clock_.time();
  out.segment = clock_.segment();
  out.paused = clock_.paused();
  out.speed = clock_.speed();
  if (draft_) out.activities = draft_->requests;
  for (const Waiting& one : queue_) out.activities.push_back(one.asked.request);
  if (out.activities.empty() && seek_) out.activities.push_back(Seek{*seek_});
  out.refusal = refusal_;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const MotionSetup& setup = bodies_[i]->motion().setup();
    BodyStatus body;
    body.name = bodies_[i]->name();
    body.method = setup.method;
    body.step = setup.step;
    body.methods = scene::methodsFor(playing_.scene.bodies[i]);
    const Body& seen = drawn(i);
    if (&seen != bodies_[i].get()) body.held = seen.state().invariants();
    body.free = freeMotion(seen.motion(), seen.regime(), seen.state().time, clock_.speed());
    out.bodies.push_back(std::move(body));
  }
  return out;
}

}  // namespace poinsot::session
