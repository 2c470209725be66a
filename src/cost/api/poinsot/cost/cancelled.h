#pragma once

#include <atomic>
#include <exception>

#include "poinsot/core/motion.h"

namespace poinsot::cost {

/**
 * Thrown by a search that gives up because its `cancel` has become true. Not a std::runtime_error, so that handlers of
 * failed searches do not catch it.
 */
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "given up"; }
};

/** The default: the search is not cancelled. */
inline const std::atomic<bool> kNeverCancelled{false};

inline void throwIf(const std::atomic<bool>& cancel) {
  if (cancel) throw Cancelled();
}

/** Takes the steps that motion.at(t) needs, or throws Cancelled. */
inline void prepare(Motion& motion, double t, const std::atomic<bool>& cancel) {
  if (cancel || !motion.prepare(t, cancel)) throw Cancelled();
}

}  // namespace poinsot::cost
