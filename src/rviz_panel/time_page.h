#pragma once

#include <algorithm>
#include <cmath>

namespace poinsot::rviz_panel {

/**
 * The stretch of simulation time that a slider of finite length shows: like a page of a book, it turns to where t is.
 */
class TimePage {
 public:
  /** Pages of `span` seconds that begin at 0, or, with `both_sides`, of twice that, the middle of one at 0. */
  explicit TimePage(double span = 60, bool both_sides = false)
      : width_(both_sides ? 2 * span : span), origin_(both_sides ? -span : 0), from_(origin_) {}

  double from() const { return from_; }
  double to() const { return from_ + width_; }

  /** Turns to the page with t on it; stays where t is on this one, its edges included. Not finite: stays. */
  void turnTo(double t) {
    if (!std::isfinite(t) || (t >= from() && t <= to())) return;
    from_ = origin_ + width_ * std::floor((t - origin_) / width_);
  }

  /** Where t is on the page, from 0 to 1; what is not on it counts as its nearer edge. */
  double shareAt(double t) const {
    const double share = (t - from_) / width_;
    return std::isnan(share) ? 0 : std::clamp(share, 0.0, 1.0);
  }
  double timeAt(double share) const { return from_ + share * width_; }

 private:
  double width_;
  double origin_;
  double from_;
};

}  // namespace poinsot::rviz_panel
