#include "poinsot/session/moving_body.h"

#include <limits>
#include <sstream>
#include <stdexcept>

#include "poinsot/scene/motion_setup.h"

namespace poinsot::session {

MovingBody::MovingBody(const scene::Body& body)
    : name_(body.name),
      motion_(scene::motionSetup(body)),
      accuracy_(body.accuracy && !body.accuracy->by_default ? body.accuracy->error
                                                            : std::numeric_limits<double>::quiet_NaN()),
      state_(motion_.at(0)) {}

bool MovingBody::move(const Tick& tick) {
  try {
    if (tick.time != state_.time) state_ = motion_.at(tick.time);
  } catch (const std::runtime_error& error) {  // range_error, NoConvergence
    std::ostringstream out;
    out << "body " << name_ << " under " << motion_.setup().method << " at t = " << tick.time << " s: " << error.what();
    throw std::runtime_error(out.str());
  }
  const Invariants now = state_.invariants();
  const bool continues = segment_ == tick.segment;
  if (!continues) {
    segment_ = tick.segment;
    segment_start_ = now;
  }
  energy_drift_ = poinsot::energyDrift(now, segment_start_);
  momentum_drift_ = poinsot::momentumDrift(now, segment_start_);
  return continues;
}

}  // namespace poinsot::session
