#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace poinsot::tools {

/**
 * The times 0, 1/rate, 2/rate, … and last exactly `duration`, which replaces a sample that differs from it by rounding
 * alone.
 */
class SampleTimes {
 public:
  /** @param duration [s] and @param rate [Hz], positive and finite. */
  SampleTimes(double duration, double rate)
      : duration_(duration), rate_(rate), intervals_(intervals(duration * rate)) {}

  /** Returns a double, because the count may exceed any integer type. */
  double count() const { return intervals_ + 1; }

  /** @param k 0 ≤ k < count(). */
  double at(std::int64_t k) const {
    return static_cast<double>(k) < intervals_ ? static_cast<double>(k) / rate_ : duration_;
  }

 private:
  static double intervals(double periods) {
    if (!std::isfinite(periods)) return periods;
    const double closeness = 1e-9 + 4 * std::numeric_limits<double>::epsilon() * periods;
    return std::max(1.0, std::ceil(periods - closeness));
  }

  double duration_, rate_, intervals_;
};

}  // namespace poinsot::tools
