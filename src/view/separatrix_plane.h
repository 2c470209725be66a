#pragma once

#include <Eigen/Core>
#include <cmath>

#include "even_spread.h"
#include "sorted_axes.h"

namespace poinsot::view {

/**
 * One of the two planes through the intermediate axis that hold the separatrix F = 2E μ₂, and the ellipse in it:
 *   Ω₂ = √(2E/μ₂) c,   (Ω₁, Ω₃) = √(2E/(μ₃−μ₁)) s (√((μ₃−μ₂)/μ₁), ±√((μ₂−μ₁)/μ₃)).
 * μ₁ < μ₂ < μ₃; sums and roots of positive terms only.
 */
class SeparatrixPlane {
 public:
  /** @param root √(2E), for the moments as scaled in `axes`. @param sign1,sign3 of Ω₁ and Ω₃ where s > 0. */
  SeparatrixPlane(const SortedAxes& axes, double root, double sign1, double sign3) : axes_(axes) {
    const auto& m = axes.moment;
    const double common = root / std::sqrt(m[2] - m[0]);
    size_ = {sign1 * common * (std::sqrt(m[2] - m[1]) / std::sqrt(m[0])), root / std::sqrt(m[1]),
             sign3 * common * (std::sqrt(m[1] - m[0]) / std::sqrt(m[2]))};
  }

  /** Returns the point in the direction (c, s), in the caller's order of axes. */
  Eigen::Vector3d operator()(const Direction& d) const {
    return axes_.inCallersOrder({d.s * size_[0], d.c * size_[1], d.s * size_[2]});
  }

 private:
  SortedAxes axes_;
  Eigen::Vector3d size_;
};

}  // namespace poinsot::view
