#pragma once

#include <atomic>
#include <future>
#include <optional>
#include <vector>

#include "poinsot/core/motion.h"

namespace poinsot::node {

/** Moves copies of motions to a far time on a thread of its own, so that publishing goes on meanwhile. */
class Seeker {
 public:
  struct Result {
    double time;
    std::vector<Motion> motions;
  };

  Seeker() = default;
  Seeker(const Seeker&) = delete;
  Seeker& operator=(const Seeker&) = delete;
  ~Seeker() { cancel(); }

  /** Starts, giving up what was under way. */
  void start(std::vector<Motion> motions, double time);
  void cancel();
  bool busy() const { return work_.valid(); }
  /** Where to, of what was started last. */
  double time() const { return time_; }

  /** The result, once, when it is there. Throws std::range_error, once, where a motion has no state at that time. */
  std::optional<Result> poll();

 private:
  double time_ = 0;
  std::atomic<bool> cancelled_{false};
  std::future<std::optional<Result>> work_;
};

}  // namespace poinsot::node
