#include "poinsot/ros/status_message.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <variant>

#include "poinsot/ros/conversions.h"
#include "poinsot/ros/scene_list.h"
#include "poinsot/ros/session_text.h"

namespace poinsot::node {
namespace {

std::uint8_t regimeKind(const session::BodyStatus& body) {
  using view::Regime;
  if (!body.free) return BodyStatus::UNDER_TORQUE;
  if (body.free->beside_separatrix) return BodyStatus::BESIDE_SEPARATRIX;
  switch (body.free->regime) {
    case Regime::about_smallest:
      return BodyStatus::ABOUT_SMALLEST;
    case Regime::about_largest:
      return BodyStatus::ABOUT_LARGEST;
    case Regime::separatrix:
      return BodyStatus::SEPARATRIX;
    case Regime::circle:
      return BodyStatus::CIRCLE;
    case Regime::axis_spin:
    case Regime::sphere:
      return BodyStatus::STEADY;
    case Regime::rest:
      break;
  }
  return BodyStatus::AT_REST;
}

BodyStatus bodyMessage(const session::BodyStatus& body) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  BodyStatus out;
  out.name = body.name;
  out.method = body.method;
  out.step = body.step.value_or(kNone);
  out.methods = body.methods;
  out.regime = regimeText(body);
  out.regime_kind = regimeKind(body);
  const view::Flips flips = body.free ? body.free->flips : view::Flips{false, 0, kNone};
  out.flips = flips.flips;
  out.flips_since_start = flips.since_start;
  out.time_to_next_flip = flips.to_next;
  out.held_energy = body.held ? body.held->kinetic_energy : kNone;
  out.held_momentum = body.held ? std::sqrt(body.held->momentum_squared) : kNone;
  return out;
}

Activity activityMessage(const session::Request& request) {
  Activity out;
  if (const auto* load = std::get_if<session::LoadScene>(&request)) {
    out.kind = Activity::LOAD_SCENE;
    out.scene = sceneName(load->scene);
  } else if (const auto* method = std::get_if<session::SetMethod>(&request)) {
    out.kind = Activity::SET_METHOD;
    out.body = method->body;
    out.method = method->method;
  } else if (const auto* spin = std::get_if<session::SetSpin>(&request)) {
    out.kind = Activity::SET_SPIN;
    out.body = spin->body;
  } else {  // all other requests are done at the next tick
    out.kind = std::holds_alternative<session::Reset>(request) ? Activity::RESET : Activity::SEEK;
  }
  return out;
}

}  // namespace

NodeStatus statusMessage(const session::Session& session, double rate, bool waiting_for_clock,
                         const std::vector<std::string>& scenes) {
  const session::Status status = session.status();
  NodeStatus out;
  out.header.stamp = toTime(session.clock().stamp());
  out.scene = status.scene;
  out.scene_file = status.file;
  out.scenes = scenes;
  out.time = status.time;
  out.segment = status.segment;
  out.paused = status.paused;
  out.speed = status.speed;
  out.rate = rate;
  out.busy = textOf(status.activities);
  if (status.refusal) out.refused = textOf(*status.refusal);
  for (const session::BodyStatus& body : status.bodies) out.bodies.push_back(bodyMessage(body));
  for (const session::Request& request : status.activities) out.activities.push_back(activityMessage(request));
  out.waiting_for_clock = waiting_for_clock;
  return out;
}

}  // namespace poinsot::node
