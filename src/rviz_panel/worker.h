#pragma once

#include <QThreadPool>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>

namespace poinsot::rviz_panel {

/**
 * A thread that does one job after another, such as those that wait for other programs. Its destructor waits for a
 * second at most; jobs that take longer go on by themselves, so a job must own what it uses.
 */
class Worker {
 public:
  using Answer = std::function<void()>;  ///< empty: none
  using Job = std::function<Answer()>;

  Worker() { pool_->setMaxThreadCount(1); }
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void post(Job job);
  /** Runs the answers that jobs have given so far, on the calling thread. */
  void read();
  /** Drops the jobs that have not begun, and the answer of the one that has. */
  void drop();

 private:
  struct Mailbox {
    std::mutex mutex;
    std::deque<Answer> answers;
  };

  QThreadPool* const pool_ = new QThreadPool;
  std::shared_ptr<Mailbox> mailbox_ = std::make_shared<Mailbox>();
};

}  // namespace poinsot::rviz_panel
