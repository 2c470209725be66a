#pragma once

/** What the node lets steppers take, of the machine and at once. */
namespace poinsot::node {

inline constexpr double kMostLoad = 0.8;       ///< of one core, for what a speed may ask of the steppers
inline constexpr double kMostTickSteps = 5e6;  ///< about 0.4 s, between two ticks
inline constexpr double kMostSteps = 1e9;      ///< to a time that is sought, or for a new method to the present one

}  // namespace poinsot::node
