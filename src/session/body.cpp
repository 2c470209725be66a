#include "poinsot/session/body.h"

#include <limits>

#include "poinsot/cost/cpu_time.h"

namespace poinsot::session {
namespace {

constexpr int kFewPoints = 8;  // of a polhode of which only the regime is needed

}  // namespace

Body::Body(const scene::Body& body, const MakeCompanion& companion)
    : MovingBody(body),
      regime_(view::polhode(body.inertia.moments(), body.inertia.toPrincipal(state().omega_body), kFewPoints).regime),
      companion_(companion(body, motion())) {}

double Body::cost() const {
  return meter_ ? meter_->cost() : std::numeric_limits<double>::quiet_NaN();
}

void Body::move(const Tick& tick) {
  const double before = state().time;
  const double begin = cost::threadCpuTime();
  const bool continues = MovingBody::move(tick);
  const double cpu = cost::threadCpuTime() - begin;
  if (continues && meter_) meter_->add(cpu, tick.time - before, state().time, motion());
}

double stepsTo(const Bodies& bodies, double time) {
  double sum = 0;
  for (const auto& body : bodies) sum += body->motion().stepsTo(time);
  return sum;
}

double steppingCost(const Bodies& bodies) {
  double sum = 0;
  for (const auto& body : bodies) sum += body->steppingCost();
  return sum;
}

}  // namespace poinsot::session
