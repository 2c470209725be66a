#include "poinsot/ros/seeker.h"

#include <chrono>
#include <utility>

namespace poinsot::node {

void Seeker::start(std::vector<Motion> motions, double time) {
  cancel();
  time_ = time;
  work_ = std::async(std::launch::async, [this, motions = std::move(motions), time]() mutable -> std::optional<Result> {
    for (Motion& motion : motions) {
      if (!motion.prepare(time, cancelled_)) return std::nullopt;
      motion.at(time);  // throws where there is nothing to publish
    }
    return Result{time, std::move(motions)};
  });
}

void Seeker::cancel() {
  if (!work_.valid()) return;
  cancelled_ = true;
  work_.wait();
  work_ = {};  // its result, or what it threw, is of no interest any more
  cancelled_ = false;
}

std::optional<Seeker::Result> Seeker::poll() {
  if (!work_.valid() || work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  return work_.get();
}

}  // namespace poinsot::node
