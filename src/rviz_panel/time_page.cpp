#include "time_page.h"

#include <algorithm>
#include <cmath>

namespace poinsot::rviz_panel {

TimePage::TimePage(double span, bool both_sides)
    : width_(both_sides ? 2 * span : span), origin_(both_sides ? -span : 0), from_(origin_) {}

void TimePage::turnTo(double t) {
  if (!std::isfinite(t) || (t >= from() && t <= to())) return;
  from_ = origin_ + width_ * std::floor((t - origin_) / width_);
}

double TimePage::shareAt(double t) const {
  const double share = (t - from_) / width_;
  return std::isnan(share) ? 0 : std::clamp(share, 0.0, 1.0);
}

}  // namespace poinsot::rviz_panel
