#pragma once

/** How many steps a session takes. */
namespace poinsot::session {

inline constexpr double kMostTickSteps = 5e6;    ///< about 0.4 s, between two ticks
inline constexpr double kMostSteps = 1e9;        ///< to a time that is sought, or for a new method to the present one
inline constexpr double kMostInlineSteps = 2e4;  ///< about 2 ms: more is left to the job

}  // namespace poinsot::session
