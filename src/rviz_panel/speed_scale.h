#pragma once

/** A slider for speeds from 1/100 to 100: equal ways are equal factors, and its middle is exactly 1. */
namespace poinsot::rviz_panel::speed_scale {

inline constexpr int kPositions = 400;  ///< positions are 0 … kPositions
inline constexpr double kSlowest = 0.01;
inline constexpr double kFastest = 100;

/** Magnitude of the speed at a position; positions beyond the ends count as the ends. */
double speedAt(int position);

/** The position nearest to a speed of either sign; 0 and NaN are at the slow end, what is faster at the fast one. */
int positionOf(double speed);

}  // namespace poinsot::rviz_panel::speed_scale
