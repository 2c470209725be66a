#include "poinsot/session/build.h"

#include <numeric>
#include <stdexcept>
#include <utility>

#include "limits.h"
#include "poinsot/cost/cancelled.h"
#include "poinsot/cost/resolve_accuracy.h"

namespace poinsot::session {
namespace {

void stepTo(Motion& motion, double time, const std::atomic<bool>& cancelled) {
  cost::prepare(motion, time, cancelled);
  motion.at(time);  // throws where there is nothing to publish
}

void advance(Body& body, double time, const std::atomic<bool>& cancelled) {
  Motion& motion = body.motion();
  const double steps = motion.stepsTo(time);
  if (!(steps <= kMostSteps)) {
    throw std::runtime_error(tooManySteps(body.name(), time, steps, *motion.setup().step));
  }
  stepTo(motion, time, cancelled);
}

}  // namespace

Prepared prepare(Draft draft, const std::vector<Asked>& asked, const ReadScene& read,
                 const std::atomic<bool>& cancelled) {
  Prepared out;
  out.draft = std::move(draft);
  for (const Asked& one : asked) {
    cost::throwIf(cancelled);
    try {
      out.answers.push_back(apply(one, out.draft, read));
    } catch (const std::exception& error) {
      out.answers.push_back(refusedFor(error.what()));
    }
  }
  return out;
}

BuildOrder wholeScene(scene::Scene scene, double rate, MakeCompanion companion) {
  BuildOrder out;
  out.bodies.resize(scene.bodies.size());
  std::iota(out.bodies.begin(), out.bodies.end(), 0);
  out.scene = std::move(scene);
  out.rate = rate;
  out.companion = std::move(companion);
  return out;
}

Built build(BuildOrder order, const std::atomic<bool>& cancelled) {
  Built out;
  scene::Scene part;
  for (const std::size_t i : order.bodies) part.bodies.push_back(order.scene.bodies[i]);
  out.choices = cost::resolveAccuracies(part, order.rate, cancelled);
  for (std::size_t k = 0; k < order.bodies.size(); ++k) {
    cost::throwIf(cancelled);
    const scene::Body& body = part.bodies[k];
    order.scene.bodies[order.bodies[k]] = body;
    out.bodies.push_back(std::make_unique<Body>(body, order.companion));
    out.bodies.back()->measure(order.rate);
    advance(*out.bodies.back(), order.time, cancelled);
  }
  out.scene = std::move(order.scene);
  out.indices = std::move(order.bodies);
  return out;
}

void advance(Built& built, double time, const std::atomic<bool>& cancelled) {
  for (const auto& body : built.bodies) advance(*body, time, cancelled);
}

Advanced advanced(std::vector<Motion> motions, double time, const std::atomic<bool>& cancelled) {
  for (Motion& motion : motions) stepTo(motion, time, cancelled);
  return {time, std::move(motions)};
}

}  // namespace poinsot::session
