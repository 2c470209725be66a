#include "poinsot/view/trail.h"

#include <algorithm>
#include <cmath>

namespace poinsot::view {

Trail::Trail(std::size_t capacity, double duration, double spacing)
    : ring_(std::max<std::size_t>(capacity, 2)), duration_(duration), spacing_(spacing) {}

void Trail::add(double time, const Eigen::Vector3d& point) {
  if (!std::isfinite(time) || !point.allFinite()) return;
  if (!empty()) played_ += std::abs(time - last_time_);
  last_time_ = time;
  while (!empty() && played_ - entry(0).played > duration_) dropOldest();

  const bool newest_is_kept = size_ < 2 || (entry(size_ - 1).point - entry(size_ - 2).point).stableNorm() >= spacing_;
  const bool moved = empty() || entry(size_ - 1).point != point;
  if (!newest_is_kept || !moved) {
    --size_;  // the new point takes its place
  } else if (size_ == ring_.size()) {
    dropOldest();
  }
  ring_[(first_ + size_) % ring_.size()] = {played_, point};
  ++size_;
}

void Trail::clear() {
  first_ = 0;
  size_ = 0;
  played_ = 0;
}

void Trail::dropOldest() {
  first_ = (first_ + 1) % ring_.size();
  --size_;
}

}  // namespace poinsot::view
