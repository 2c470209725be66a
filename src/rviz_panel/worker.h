#pragma once

#include <QThreadPool>
#include <deque>
#include <functional>
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
  Worker() { pool_->setMaxThreadCount(1); }
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void post(std::function<void()> job);
  /** Drops the jobs that have not begun. */
  void drop() { pool_->clear(); }

 private:
  QThreadPool* const pool_ = new QThreadPool;
};

}  // namespace poinsot::rviz_panel
