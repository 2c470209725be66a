#include "history.h"

#include <algorithm>

namespace poinsot::rviz_panel {

void History::add(const Sample& sample) {
  if (!kept_.empty() && (sample.segment != kept_.back().sample.segment || sample.stamp < last_stamp_)) clear();
  if (kept_.empty()) {
    last_stamp_ = sample.stamp;
    kept_.push_back({sample, 0});
    return;
  }
  const bool moved = sample.time != kept_.back().sample.time;
  if (moved) played_ += sample.stamp - last_stamp_;
  last_stamp_ = sample.stamp;
  // The newest is always there; it gives way to the next one while it is too close to the one before it.
  const std::size_t n = kept_.size();
  if (n >= 2 && kept_[n - 1].played - kept_[n - 2].played < spacing_) kept_.pop_back();
  if (moved || n == 1 || kept_.size() < n) {
    kept_.push_back({sample, played_});
  } else {
    kept_.back().sample = sample;
  }
  while (kept_.front().played < played_ - window_) kept_.pop_front();
}

void History::clear() {
  kept_.clear();
  played_ = 0;
}

std::vector<Point> thinned(const std::vector<Point>& points, int columns) {
  const std::size_t most = 2 * static_cast<std::size_t>(columns) + 1;
  if (points.size() <= most) return points;
  std::vector<Point> out;
  const std::size_t run = (points.size() + columns - 1) / columns;
  for (std::size_t from = 0; from < points.size(); from += run) {
    const auto begin = points.begin() + from;
    const auto end = points.begin() + std::min(from + run, points.size());
    const auto [low, high] = std::minmax_element(begin, end, [](const Point& a, const Point& b) { return a.y < b.y; });
    out.push_back(*std::min(low, high));
    if (low != high) out.push_back(*std::max(low, high));
  }
  out.push_back(points.back());
  return out;
}

}  // namespace poinsot::rviz_panel
