#include "poinsot/ros/tick_timer.h"

#include <ros/init.h>

#include <algorithm>
#include <cmath>

#include "poinsot/ros/conversions.h"

namespace poinsot::node {
namespace {

constexpr std::chrono::milliseconds kLongestSleep{100};  // what needs no tick is served at least this often
constexpr std::chrono::milliseconds kLook{1};            // between two looks at a foreign clock
constexpr std::chrono::seconds kStandsStill{1};          // a foreign clock with no tick due for so long,
constexpr double kPeriodsStill = 3;                      // and for so many periods, stands still
constexpr double kMostPeriodsBehind = 10;                // later than that, the schedule is moved
const ros::Time kOwnClockStart(1, 0);                    // not zero, which ROS reads as "no time yet"

ros::WallDuration toWallDuration(std::chrono::steady_clock::duration time) {
  return ros::WallDuration(std::chrono::duration<double>(time).count());
}

}  // namespace

TickTimer::TickTimer(Mode mode, double rate, ros::CallbackQueue& callbacks)
    : mode_(mode), period_(1.0 / rate), callbacks_(callbacks), origin_(Steady::now()) {
  counted_.since = origin_;
}

TickTimer::Wake TickTimer::wait(const std::atomic<bool>& interrupted) {
  const Wake wake = mode_ == Mode::foreign_clock ? waitForeign(interrupted) : waitSteady(interrupted);
  if (wake == Wake::due) {
    ++made_;
    ++counted_.ticks;
  }
  return wake;
}

TickTimer::Wake TickTimer::waitSteady(const std::atomic<bool>& interrupted) {
  const auto due =
      origin_ + std::chrono::duration_cast<Steady::duration>(period_ * static_cast<double>(made_since_origin_ + 1));
  // At least once, also where ticks take longer than their period: a node that is always late must still answer.
  callbacks_.callAvailable();
  for (Steady::time_point now, end = Steady::now() + kLongestSleep; (now = Steady::now()) < due;) {
    if (!ros::ok() || interrupted) return Wake::ended;
    if (now >= end) return Wake::idle;
    callbacks_.callAvailable(toWallDuration(std::min(due, end) - now));
  }
  ++made_since_origin_;
  countLateness(due);
  return ros::ok() && !interrupted ? Wake::due : Wake::ended;
}

TickTimer::Wake TickTimer::waitForeign(const std::atomic<bool>& interrupted) {
  const Steady::time_point begin = Steady::now();
  callbacks_.callAvailable();
  while (ros::ok() && !interrupted) {
    const ros::Time now = ros::Time::now();
    const bool jumped_back = now < foreign_last_;
    if (!now.isZero() && (jumped_back || now >= foreign_due_)) {
      const ros::Duration period(period_.count());
      const bool behind = jumped_back || now - foreign_due_ > period;
      foreign_due_ = (behind ? now : foreign_due_) + period;
      foreign_last_ = now;
      foreign_waited_ = {};
      return Wake::due;
    }
    const Steady::duration waited = Steady::now() - begin;
    if (waited >= kLongestSleep) {
      foreign_waited_ += waited;
      return Wake::idle;
    }
    callbacks_.callAvailable(toWallDuration(kLook));
  }
  return Wake::ended;
}

bool TickTimer::waitsForClock() const {
  return foreign_waited_ > std::max<std::chrono::duration<double>>(kStandsStill, kPeriodsStill * period_);
}

void TickTimer::countLateness(Steady::time_point due) {
  const double lateness = std::chrono::duration<double>(Steady::now() - due).count();
  counted_.sum += lateness;
  counted_.sum_of_squares += lateness * lateness;
  counted_.worst = std::max(counted_.worst, lateness);
  if (lateness > kMostPeriodsBehind * period_.count()) {
    origin_ = Steady::now();
    made_since_origin_ = 0;
  }
}

session::Nanoseconds TickTimer::stamp() const {
  if (mode_ != Mode::own_clock) return toNanoseconds(ros::Time::now());
  return toNanoseconds(kOwnClockStart + ros::Duration(period_.count() * static_cast<double>(made_)));
}

Punctuality TickTimer::takePunctuality() {
  const auto now = Steady::now();
  Punctuality out;
  out.ticks = counted_.ticks;
  const double n = static_cast<double>(std::max<std::int64_t>(1, counted_.ticks));
  out.rate =
      static_cast<double>(counted_.ticks) / std::max(1e-9, std::chrono::duration<double>(now - counted_.since).count());
  out.mean_lateness = counted_.sum / n;
  out.jitter = std::sqrt(std::max(0.0, counted_.sum_of_squares / n - out.mean_lateness * out.mean_lateness));
  out.worst = counted_.worst;
  counted_ = {};
  counted_.since = now;
  return out;
}

}  // namespace poinsot::node
