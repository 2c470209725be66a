#include "poinsot/ros/pacer.h"

#include <ros/init.h>

#include <algorithm>
#include <cmath>
#include <thread>

namespace poinsot::node {
namespace {

constexpr std::chrono::milliseconds kLongestSleep{100};  // so that a shutdown is noticed at any rate
constexpr double kMostPeriodsBehind = 10;                // then the schedule is moved instead of caught up with
const ros::Time kOwnClockStart(1, 0);                    // not zero, which ROS reads as "no time yet"

}  // namespace

Pacer::Pacer(Mode mode, double rate)
    : mode_(mode),
      period_(1.0 / rate),
      ros_rate_(ros::Duration(1.0 / rate)),
      origin_(Steady::now()),
      counted_since_(origin_) {}

bool Pacer::wait() {
  if (mode_ == Mode::foreign_clock) {
    ros_rate_.sleep();
  } else if (!waitSteady()) {
    return false;
  }
  ++made_;
  ++counted_;
  return ros::ok();
}

bool Pacer::waitSteady() {
  const auto due = origin_ + std::chrono::duration_cast<Steady::duration>(period_ * static_cast<double>(++due_));
  for (auto now = Steady::now(); now < due; now = Steady::now()) {
    if (!ros::ok()) return false;
    std::this_thread::sleep_for(std::min<Steady::duration>(due - now, kLongestSleep));
  }
  const double lateness = std::chrono::duration<double>(Steady::now() - due).count();
  sum_ += lateness;
  sum_of_squares_ += lateness * lateness;
  worst_ = std::max(worst_, lateness);
  if (lateness > kMostPeriodsBehind * period_.count()) {
    origin_ = Steady::now();
    due_ = 0;
  }
  return true;
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
