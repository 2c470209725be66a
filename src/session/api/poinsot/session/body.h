#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "poinsot/cost/cost_meter.h"
#include "poinsot/session/companion.h"
#include "poinsot/session/moving_body.h"
#include "poinsot/session/status.h"
#include "poinsot/view/polhode.h"

namespace poinsot::session {

/** Returns the regime of the free motion that begins at the body's start; under torques, if they did not act. */
view::Regime regimeOf(const scene::Body& body);

/**
 * Returns what is known of a body's free motion at t [s]; nothing for a body under torques.
 * @param regime of that motion, as regimeOf() returns it.
 * @param speed of play: its sign says on which side of t the next flip is looked for.
 */
std::optional<FreeMotion> freeMotion(const Motion& motion, view::Regime regime, double time, double speed);

/** A body that plays: with its companion outside of the session and, where that is measured, what it costs. */
class Body : public MovingBody {
 public:
  Body(const scene::Body& body, const MakeCompanion& companion);

  Companion& companion() const { return *companion_; }
  /** Of the free motion that begins at its start. */
  view::Regime regime() const { return regime_; }

  /** Measures what it costs from now on, with a short trial run first. @param rate of the ticks [Hz]. */
  void measure(double rate) { meter_.emplace(motion(), rate); }
  /** CPU seconds per simulated second, as measured lately; NaN where it is not measured. */
  double cost() const;
  /** Of its stepping alone, which a faster play multiplies; 0 where it has no steps or is not measured. */
  double steppingCost() const { return meter_ ? meter_->steppingCost() : 0; }

  /** MovingBody::move, its cost measured. */
  void move(const Tick& tick);

 private:
  view::Regime regime_;
  std::unique_ptr<Companion> companion_;
  std::optional<cost::CostMeter> meter_;
};

using Bodies = std::vector<std::unique_ptr<Body>>;

/** Returns how many steps all bodies together have to take to the time t [s]. */
double stepsTo(const Bodies& bodies, double time);

/** Returns what the steps of all bodies together cost [CPU s per simulated s]. */
double steppingCost(const Bodies& bodies);

}  // namespace poinsot::session
