#include "poinsot/core/stepper_trajectory.h"

#include <algorithm>
#include <utility>

namespace poinsot {
namespace {

constexpr std::int64_t kFirstSpacing = 1024;
constexpr std::int64_t kFinePerCoarse = 32;
constexpr std::size_t kMostCheckpoints = 16384;

}  // namespace

StepperTrajectory::StepperTrajectory(std::shared_ptr<const Stepper> stepper, const RotationState& start, double step)
    : stepper_(std::move(stepper)), step_(step), cursor_{0, start}, coarse_{{0, start}}, spacing_(kFirstSpacing) {}

std::int64_t StepperTrajectory::fineSpacing() const {
  return spacing_ / kFinePerCoarse;
}

const StepperTrajectory::Checkpoint& StepperTrajectory::nearestBefore(std::int64_t n) const {
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

std::int64_t StepperTrajectory::stepsTo(std::int64_t n) const {
  return n - nearestBefore(n).n;
}

const RotationState& StepperTrajectory::at(std::int64_t n) {
  static const std::atomic<bool> never{false};
  moveTo(n, never);
  return cursor_.state;
}

bool StepperTrajectory::moveTo(std::int64_t n, const std::atomic<bool>& cancel) {
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

void StepperTrajectory::advanceTo(std::int64_t n) {
  work_ += stepper_->advance(cursor_.state, cursor_.n, step_, n - cursor_.n);
  cursor_.n = n;
}

void StepperTrajectory::remember(bool known) {
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

}  // namespace poinsot
