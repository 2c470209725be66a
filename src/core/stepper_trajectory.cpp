#include "poinsot/core/stepper_trajectory.h"

#include <algorithm>

namespace poinsot {
namespace {

constexpr std::int64_t kFirstSpacing = 1024;
constexpr std::int64_t kFinePerCoarse = 32;
constexpr std::size_t kMostCheckpoints = 16384;

}  // namespace

template <class Flow>
GridTrajectory<Flow>::GridTrajectory(Flow flow, const State& start, double step)
    : flow_(std::move(flow)), step_(step), cursor_{0, start}, coarse_{{0, start}}, spacing_(kFirstSpacing) {}

template <class Flow>
std::int64_t GridTrajectory<Flow>::fineSpacing() const {
  return spacing_ / kFinePerCoarse;
}

template <class Flow>
const typename GridTrajectory<Flow>::Checkpoint& GridTrajectory<Flow>::nearestBefore(std::int64_t n) const {
  const auto last = [n](const std::vector<Checkpoint>& list) {
    const auto after = std::upper_bound(list.begin(), list.end(), n,
                                        [](std::int64_t value, const Checkpoint& c) { return value < c.n; });
    return after == list.begin() ? nullptr : &*std::prev(after);
  };
  const Checkpoint* best = last(coarse_);
  if (const Checkpoint* fine = last(fine_); fine && fine->n > best->n) best = fine;
  if (cursor_.n <= n && cursor_.n > best->n) best = &cursor_;
  return *best;
}

template <class Flow>
std::int64_t GridTrajectory<Flow>::stepsTo(std::int64_t n) const {
  return n - nearestBefore(n).n;
}

template <class Flow>
const typename GridTrajectory<Flow>::State& GridTrajectory<Flow>::at(std::int64_t n) {
  static const std::atomic<bool> never{false};
  moveTo(n, never);
  return cursor_.state;
}

template <class Flow>
bool GridTrajectory<Flow>::moveTo(std::int64_t n, const std::atomic<bool>& cancel) {
  if (const Checkpoint& start = nearestBefore(n); &start != &cursor_) cursor_ = Checkpoint(start);
  while (cursor_.n < n) {
    if (cancel) return false;
    const bool known = cursor_.n < furthest_;  // going over old ground: note the way more finely
    const std::int64_t spacing = known ? fineSpacing() : spacing_;
    advanceTo(std::min(n, (cursor_.n / spacing + 1) * spacing));
    furthest_ = std::max(furthest_, cursor_.n);
    remember(known);
  }
  return true;
}

template <class Flow>
void GridTrajectory<Flow>::advanceTo(std::int64_t n) {
  work_ += flow_.advance(cursor_.state, cursor_.n, step_, n - cursor_.n);
  cursor_.n = n;
}

template <class Flow>
void GridTrajectory<Flow>::remember(bool known) {
  if (cursor_.n % spacing_ == 0) {
    if (cursor_.n <= coarse_.back().n) return;
    coarse_.push_back(cursor_);
    if (coarse_.size() < kMostCheckpoints) return;
    for (std::size_t i = 0; 2 * i < coarse_.size(); ++i) coarse_[i] = coarse_[2 * i];
    coarse_.resize((coarse_.size() + 1) / 2);
    spacing_ *= 2;
    fine_.clear();
  } else if (known && cursor_.n % fineSpacing() == 0) {
    const std::int64_t interval = cursor_.n / spacing_;
    if (!fine_.empty() && (fine_.front().n / spacing_ != interval || fine_.back().n >= cursor_.n)) {
      if (fine_.front().n / spacing_ == interval) return;  // noted already
      fine_.clear();
    }
    fine_.push_back(cursor_);
  }
}

template class GridTrajectory<FreeFlow>;
template class GridTrajectory<TorquedFlow>;

}  // namespace poinsot
