#pragma once

#include <algorithm>
#include <cmath>

/** A slider for speeds from 1/100 to 100: equal ways are equal factors, and its middle is exactly 1. */
namespace poinsot::rviz_panel::speed_scale {

inline constexpr int kPositions = 400;  ///< positions are 0 … kPositions
inline constexpr double kSlowest = 0.01;
inline constexpr double kFastest = 100;

inline constexpr double kPositionsPerDecade = kPositions / 4.0;
inline constexpr int kMiddle = kPositions / 2;

/** Magnitude of the speed at a position; positions beyond the ends count as the ends. */
inline double speedAt(int position) {
  return std::pow(10, (std::clamp(position, 0, kPositions) - kMiddle) / kPositionsPerDecade);
}

/** The position nearest to a speed of either sign; 0 and NaN are at the slow end, what is faster at the fast one. */
inline int positionOf(double speed) {
  const double magnitude = std::abs(speed);
  if (!(magnitude > kSlowest)) return 0;
  if (magnitude >= kFastest) return kPositions;
  return kMiddle + static_cast<int>(std::lround(kPositionsPerDecade * std::log10(magnitude)));
}

}  // namespace poinsot::rviz_panel::speed_scale
