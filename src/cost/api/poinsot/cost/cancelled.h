#pragma once

#include <atomic>
#include <exception>

namespace poinsot::cost {

/** Thrown by a search that gives up because its `cancel` has become true. No std::runtime_error: no failure of the
 * search. */
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "given up"; }
};

/** For whoever waits for the end. */
inline const std::atomic<bool> kNeverCancelled{false};

inline void throwIf(const std::atomic<bool>& cancel) {
  if (cancel) throw Cancelled();
}

}  // namespace poinsot::cost
