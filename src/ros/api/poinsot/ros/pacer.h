#pragma once

#include <ros/rate.h>
#include <ros/time.h>

#include <chrono>
#include <cstdint>

namespace poinsot::node {

/** How regularly the ticks came, over some stretch of steady time. */
struct Punctuality {
  std::int64_t ticks = 0;
  double rate = 0;           ///< [Hz]
  double mean_lateness = 0;  ///< of the tick behind its schedule [s]
  double jitter = 0;         ///< standard deviation of the lateness [s]
  double worst = 0;          ///< largest lateness [s]
};

/**
 * Waits for the next tick and says which stamp it has.
 *
 * Three ways: by the steady clock, stamped with ROS time, where ROS time is the wall's; by the steady clock, making the
 * stamps itself (the node owns /clock); by somebody else's /clock.
 */
class Pacer {
 public:
  enum class Mode { wall, own_clock, foreign_clock };

  Pacer(Mode mode, double rate);

  Mode mode() const { return mode_; }

  /** Returns when the next tick is due, or false when ROS shuts down. */
  bool wait();

  /** The stamp of the tick that wait() returned for; zero while a foreign clock has not begun. */
  ros::Time stamp() const;

  /** Since the last call. Lateness is not known under a foreign clock. */
  Punctuality takePunctuality();

 private:
  using Steady = std::chrono::steady_clock;

  bool waitSteady();

  Mode mode_;
  std::chrono::duration<double> period_;
  ros::Rate ros_rate_;
  Steady::time_point origin_;  ///< tick k is due at origin_ + k·period_
  std::int64_t due_ = 0;
  std::int64_t made_ = 0;  ///< ticks since the start, for the stamps of an own clock

  Steady::time_point counted_since_;
  std::int64_t counted_ = 0;
  double sum_ = 0, sum_of_squares_ = 0, worst_ = 0;
};

}  // namespace poinsot::node
