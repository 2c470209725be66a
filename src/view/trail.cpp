#include "poinsot/view/trail.h"

#include <algorithm>

namespace poinsot::view {

Trail::Trail(std::size_t capacity, double length, double spacing)
    : ring_(std::max<std::size_t>(capacity, 2)), length_(length), spacing_(spacing) {}

void Trail::add(const Eigen::Vector3d& point) {
  if (!point.allFinite()) return;
  if (!empty()) travelled_ += (point - entry(size_ - 1).point).stableNorm();
  while (!empty() && travelled_ - entry(0).travelled > length_) dropOldest();

  const bool newest_is_kept = size_ < 2 || (entry(size_ - 1).point - entry(size_ - 2).point).stableNorm() >= spacing_;
  const bool moved = empty() || entry(size_ - 1).point != point;
  if (!newest_is_kept || !moved) {
    --size_;  // the new point takes its place
  } else if (size_ == ring_.size()) {
    dropOldest();
  }
  ring_[(first_ + size_) % ring_.size()] = {travelled_, point};
  ++size_;
}

void Trail::clear() {
  first_ = 0;
  size_ = 0;
  travelled_ = 0;
}

void Trail::dropOldest() {
  first_ = (first_ + 1) % ring_.size();
  --size_;
}

}  // namespace poinsot::view
