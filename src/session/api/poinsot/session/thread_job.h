#pragma once

#include <atomic>
#include <chrono>
#include <future>

#include "poinsot/session/job.h"

namespace poinsot::session {

/** A job on a thread of its own. Its destructor cancels it and waits. */
class ThreadJob : public Job {
 public:
  ThreadJob() = default;
  ~ThreadJob() override { cancel(); }
  ThreadJob(const ThreadJob&) = delete;
  ThreadJob& operator=(const ThreadJob&) = delete;

  void start(Work work) override;
  bool busy() const override { return outcome_.valid(); }
  void cancel() override { cancelled_ = true; }
  std::optional<Outcome> poll() override;

  /** Whether nothing runs, or what runs has ended within that time. */
  bool endsWithin(std::chrono::milliseconds patience) const;

 private:
  std::atomic<bool> cancelled_{false};
  std::future<Outcome> outcome_;  // last: it is waited for before the flag goes
};

}  // namespace poinsot::session
