#include "history.h"

#include <algorithm>

namespace poinsot::rviz_panel {

void History::add(const BodyState& state) {
  const double stamp = state.header.stamp.toSec();
  if (!kept_.empty() && (state.segment != newest().segment || stamp < last_stamp_)) clear();
  const bool moved = !kept_.empty() && state.time != newest().time;
  if (moved) played_ += stamp - last_stamp_;
  last_stamp_ = stamp;
  // The newest is always there; it gives way to the next one while it is too close to the one before it.
  const std::size_t n = kept_.size();
  if (n >= 2 && (!moved || kept_[n - 1].played - kept_[n - 2].played < spacing_)) kept_.pop_back();
  kept_.push_back({state, played_});
  while (kept_.front().played < played_ - window_) kept_.pop_front();
}

void History::clear() {
  kept_.clear();
  played_ = 0;
}

QPolygonF thinned(const QPolygonF& points, int columns) {
  if (points.size() <= 2 * columns + 1) return points;
  QPolygonF out;
  const int run = (points.size() + columns - 1) / columns;
  for (int from = 0; from < points.size(); from += run) {
    const auto begin = points.begin() + from;
    const auto end = points.begin() + std::min(from + run, points.size());
    const auto [low, high] =
        std::minmax_element(begin, end, [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
    out << *std::min(low, high);
    if (low != high) out << *std::max(low, high);
  }
  return out << points.back();
}

}  // namespace poinsot::rviz_panel
