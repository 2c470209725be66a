#include "poinsot/session/body.h"

#include <limits>

#include "poinsot/cost/cpu_time.h"

namespace poinsot::session {
namespace {

constexpr int kFewPoints = 8;               // of a polhode of which only the regime is needed
constexpr double kBesideSeparatrix = 3e-7;  // k': some last bits of E and |L|²

}  // namespace

view::Regime regimeOf(const scene::Body& body) {
  return view::polhode(body.inertia.moments(), body.inertia.toPrincipal(body.omega_body), kFewPoints).regime;
}

std::optional<FreeMotion> freeMotion(const Motion& motion, view::Regime regime, double time, double speed) {
  const ClosedForm* exact = motion.closedForm();
  if (!exact) return std::nullopt;
  const MotionSetup& start = motion.setup();
  FreeMotion out;
  out.regime = regime;
  out.moments = start.inertia.moments();
  out.omega_principal = start.inertia.toPrincipal(start.omega_body);
  const double distance = exact->separatrixDistance();
  out.beside_separatrix = distance > 0 && distance < kBesideSeparatrix;
  out.flips = view::flipsOf(*exact, time, speed);
  return out;
}

Body::Body(const scene::Body& body, const MakeCompanion& companion)
    : MovingBody(body), regime_(regimeOf(body)), companion_(companion(body, motion())) {}

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
