#pragma once

#include <ros/callback_queue.h>
#include <ros/time.h>

#include <atomic>
#include <chrono>
#include <cstdint>

#include "poinsot/session/tick.h"

namespace poinsot::node {

/** How regularly the ticks came, over some stretch of steady time. Times are in seconds. */
struct Punctuality {
  std::int64_t ticks = 0;
  double rate = 0;           ///< [Hz]
  double mean_lateness = 0;  ///< of the tick behind its schedule [s]
  double jitter = 0;         ///< standard deviation of the lateness [s]
  double worst = 0;          ///< largest lateness [s]
};

/**
 * Waits for the next tick, calls ROS's callbacks meanwhile, and says which stamp the tick has.
 *
 * Three ways: by the steady clock, stamped with ROS time, where ROS time is the wall's; by the steady clock, making the
 * stamps itself (the node owns /clock); by somebody else's /clock.
 */
class TickTimer {
 public:
  enum class Mode { wall, own_clock, foreign_clock };

  /** @param callbacks called while it waits, in the thread that waits. */
  TickTimer(Mode mode, double rate, ros::CallbackQueue& callbacks);

  Mode mode() const { return mode_; }

  /** Why wait() returned. */
  enum class Wake {
    due,   ///< the next tick is to be made
    idle,  ///< it is not due yet, or a foreign clock stands still; a tenth of a second of the wall's time has gone by
    ended  ///< ROS shuts down, or `interrupted` is true
  };
  Wake wait(const std::atomic<bool>& interrupted);

  /** The stamp of a tick that is due; zero while a foreign clock has not begun. */
  session::Nanoseconds stamp() const;

  /** Whether a foreign clock stands still: no tick was due for a second of the wall's time, and for three periods. */
  bool waitsForClock() const;

  /** Returns how regular the ticks were since the last call. Lateness is not known under a foreign clock. */
  Punctuality takePunctuality();

 private:
  using Steady = std::chrono::steady_clock;

  Wake waitSteady(const std::atomic<bool>& interrupted);
  Wake waitForeign(const std::atomic<bool>& interrupted);
  void countLateness(Steady::time_point due);

  Mode mode_;
  std::chrono::duration<double> period_;
  ros::CallbackQueue& callbacks_;
  ros::Time foreign_due_, foreign_last_;  ///< by a foreign clock: of the next tick, and of the last
  Steady::duration foreign_waited_{};     ///< for a foreign clock since its last tick was due
  Steady::time_point origin_;             ///< tick k is due at origin_ + k·period_
  std::int64_t made_since_origin_ = 0;
  std::int64_t made_ = 0;  ///< ticks since the start, for the stamps of an own clock

  /** Of the ticks that takePunctuality() has not told yet. */
  struct {
    Steady::time_point since;
    std::int64_t ticks = 0;
    double sum = 0, sum_of_squares = 0, worst = 0;
  } counted_;
};

}  // namespace poinsot::node
