#pragma once

#include <cstdint>
#include <optional>

#include "poinsot/session/tick.h"

namespace poinsot::session {

/**
 * Turns stamps into simulation time: t is piecewise linear in the stamp.
 *
 * Commands take effect at the next tick, never between two, so that between two ticks t runs at exactly the rate that
 * the earlier one stated. Not thread-safe.
 */
class Clock {
 public:
  /** @param step_length what step() advances t by [s], positive. */
  explicit Clock(double step_length) : step_length_(step_length) {}

  void pause(bool paused);
  bool paused() const { return paused_; }

  /** While paused: lets t run at rate 1 for one step length, to its exact end. Calls add up. Ignored while playing. */
  void step() { steps_left_ += paused_ ? 1 : 0; }

  /** Any finite speed; negative plays backwards. */
  void setSpeed(double speed) { speed_ = speed; }
  double speed() const { return speed_; }

  /** Jumps to t at the next tick, which begins a new segment. */
  void jumpTo(double t);

  /** The next tick begins a new segment, at the t that it would have anyway: something else moves from there on. */
  void beginSegment() { new_segment_ = true; }

  /** The time of the last tick; the start time before the first. */
  double time() const { return time_; }

  /** From which t the next tick goes on: time(), or that of a jump to come. */
  double comingTime() const { return jump_.value_or(time_); }

  /** The segment of the last tick. */
  std::uint32_t segment() const { return segment_; }

  /** The stamp of the last tick. */
  Nanoseconds stamp() const { return stamp_; }

  /** What t would be at `now` if nothing is commanded before; time() before the first tick. */
  double timeAt(Nanoseconds now) const;

  /** The time of the tick that comes at `now`: timeAt(now), or that of a jump to come. */
  double nextTime(Nanoseconds now) const { return jump_.value_or(timeAt(now)); }

  /**
   * @param now the present stamp.
   * @return nothing when `now` is not after the last tick's stamp (a repeated stamp would be dropped by tf). The stamp
   *         returned is `now`, or earlier, when a step ended between the last tick and now.
   */
  std::optional<Tick> tick(Nanoseconds now);

  /** True when `now` lies before the last tick: somebody else's clock jumped back. */
  bool jumpedBack(Nanoseconds now) const { return started_ && now < stamp_; }

  /** Forgets the stamps: t goes on from where it is, in a new segment, at whatever stamp comes next. */
  void restartStamps();

 private:
  void anchorHere();

  double step_length_;  ///< [s]
  bool paused_ = false;
  double speed_ = 1;
  std::int64_t steps_left_ = 0;
  std::optional<double> jump_;

  bool started_ = false;
  Nanoseconds stamp_ = 0;
  double time_ = 0;
  double rate_ = 0;
  std::uint32_t segment_ = 0;
  bool new_segment_ = false;

  // t = anchor_time_ + rate_ · (stamp − anchor_stamp_)
  Nanoseconds anchor_stamp_ = 0;
  double anchor_time_ = 0;
  std::optional<Nanoseconds> step_end_;
};

}  // namespace poinsot::session
