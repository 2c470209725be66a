#pragma once

#include <cstdint>

namespace poinsot::session {

/** A stamp, or a length of time. Whole numbers, so that sums of them do not round. */
using Nanoseconds = std::int64_t;

constexpr Nanoseconds kSecond = 1000000000;

/** In seconds, to the last bits of a double. */
inline double toSeconds(Nanoseconds time) {
  const Nanoseconds whole = time / kSecond;
  return static_cast<double>(whole) + 1e-9 * static_cast<double>(time % kSecond);
}

/** What one tick says about time. From `stamp` until the next tick's, simulation time runs at `time_rate`. */
struct Tick {
  Nanoseconds stamp = 0;
  double time = 0;            ///< simulation time t [s]
  double time_rate = 0;       ///< dt/dstamp from here on
  std::uint32_t segment = 0;  ///< continuity holds only inside one
};

}  // namespace poinsot::session
