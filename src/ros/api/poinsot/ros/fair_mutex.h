#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace poinsot::node {

/**
 * A mutex that is given to whoever asked first. With std::mutex, ticks that take longer than their period would take it
 * again before anybody else wakes up, and a busy node could not even be paused.
 */
class FairMutex {
 public:
  void lock() {
    std::unique_lock<std::mutex> guard(mutex_);
    const std::uint64_t mine = asked_++;
    changed_.wait(guard, [&] { return served_ == mine; });
  }

  void unlock() {
    {
      const std::lock_guard<std::mutex> guard(mutex_);
      ++served_;
    }
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t asked_ = 0, served_ = 0;
};

}  // namespace poinsot::node
