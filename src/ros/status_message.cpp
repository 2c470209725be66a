#include "poinsot/ros/status_message.h"

#include <limits>

#include "poinsot/ros/conversions.h"
#include "poinsot/ros/session_text.h"

namespace poinsot::node {
namespace {

BodyStatus bodyMessage(const session::BodyStatus& body) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  BodyStatus out;
  out.name = body.name;
  out.method = body.method;
  out.step = body.step.value_or(kNone);
  out.methods = body.methods;
  out.regime = regimeText(body);
  const view::Flips flips = body.free ? body.free->flips : view::Flips{false, 0, kNone};
  out.flips = flips.flips;
  out.flips_since_start = flips.since_start;
  out.time_to_next_flip = flips.to_next;
  return out;
}

}  // namespace

NodeStatus statusMessage(const session::Session& session, double rate, const std::vector<std::string>& scenes) {
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
  return out;
}

}  // namespace poinsot::node
