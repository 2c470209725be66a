#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>

namespace poinsot::rviz_panel {

/** Closures handed from one thread to another, which runs them when it likes. */
class Mailbox {
 public:
  void post(std::function<void()> letter);
  /** Runs what has been posted so far, on the calling thread. */
  void read();

 private:
  std::mutex mutex_;
  std::deque<std::function<void()>> letters_;
};

/**
 * A thread that does one job after another: what may wait for other programs. Whoever destroys a worker waits for its
 * jobs for a second at most; what takes longer is left to itself, and must therefore own what it uses.
 */
class Worker {
 public:
  Worker();
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void post(std::function<void()> job);
  /** Drops the jobs that have not begun. */
  void drop();

 private:
  struct Shared {
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<std::function<void()>> jobs;
    bool stop = false;
    bool ended = false;
  };
  static void work(const std::shared_ptr<Shared>& shared);

  std::shared_ptr<Shared> shared_;
};

}  // namespace poinsot::rviz_panel
