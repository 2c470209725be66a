#include "poinsot/ros/pacer.h"

#include <ros/init.h>

#include <algorithm>
#include <cmath>
#include <thread>

namespace poinsot::node {
namespace {

constexpr std::chrono::milliseconds kLongestSleep{100};  // what does not wait for ticks is looked after so often
constexpr std::chrono::milliseconds kLook{1};            // at a foreign clock
constexpr double kMostPeriodsBehind = 10;                // then the schedule is moved instead of caught up with
const ros::Time kOwnClockStart(1, 0);                    // not zero, which ROS reads as "no time yet"

}  // namespace

Pacer::Pacer(Mode mode, double rate)
    : mode_(mode), period_(1.0 / rate), origin_(Steady::now()), counted_since_(origin_) {}

Pacer::Wake Pacer::wait(const std::atomic<bool>& interrupted) {
  const Wake wake = mode_ == Mode::foreign_clock ? waitForeign(interrupted) : waitSteady(interrupted);
  if (wake == Wake::due) {
    ++made_;
    ++counted_;
  }
  return wake;
}

Pacer::Wake Pacer::waitSteady(const std::atomic<bool>& interrupted) {
  const auto due =
      origin_ + std::chrono::duration_cast<Steady::duration>(period_ * static_cast<double>(made_since_origin_ + 1));
  const Steady::time_point now = Steady::now();
  if (!ros::ok() || interrupted) return Wake::ended;
  if (due - now > kLongestSleep) {
    std::this_thread::sleep_for(kLongestSleep);
    return ros::ok() && !interrupted ? Wake::idle : Wake::ended;
  }
  std::this_thread::sleep_until(due);
  ++made_since_origin_;
  countLateness(due);
  return ros::ok() && !interrupted ? Wake::due : Wake::ended;
}

Pacer::Wake Pacer::waitForeign(const std::atomic<bool>& interrupted) {
  const Steady::time_point begin = Steady::now();
  while (ros::ok() && !interrupted) {
    const ros::Time now = ros::Time::now();
    const bool jumped_back = now < foreign_last_;
    if (!now.isZero() && (jumped_back || now >= foreign_due_)) {
      const ros::Duration period(period_.count());
      const bool behind = jumped_back || now - foreign_due_ > period;
      foreign_due_ = (behind ? now : foreign_due_) + period;
      foreign_last_ = now;
      return Wake::due;
    }
    if (Steady::now() - begin >= kLongestSleep) return Wake::idle;
    std::this_thread::sleep_for(kLook);
  }
  return Wake::ended;
}

void Pacer::countLateness(Steady::time_point due) {
  const double lateness = std::chrono::duration<double>(Steady::now() - due).count();
  sum_ += lateness;
  sum_of_squares_ += lateness * lateness;
  worst_ = std::max(worst_, lateness);
  if (lateness > kMostPeriodsBehind * period_.count()) {
    origin_ = Steady::now();
    made_since_origin_ = 0;
  }
}

ros::Time Pacer::stamp() const {
  if (mode_ != Mode::own_clock) return ros::Time::now();
  return kOwnClockStart + ros::Duration(period_.count() * static_cast<double>(made_));
}

Punctuality Pacer::takePunctuality() {
  const auto now = Steady::now();
  Punctuality out;
  out.ticks = counted_;
  const double n = static_cast<double>(std::max<std::int64_t>(1, counted_));
  out.rate =
      static_cast<double>(counted_) / std::max(1e-9, std::chrono::duration<double>(now - counted_since_).count());
  out.mean_lateness = sum_ / n;
  out.jitter = std::sqrt(std::max(0.0, sum_of_squares_ / n - out.mean_lateness * out.mean_lateness));
  out.worst = worst_;
  counted_ = 0;
  sum_ = sum_of_squares_ = worst_ = 0;
  counted_since_ = now;
  return out;
}

}  // namespace poinsot::node
