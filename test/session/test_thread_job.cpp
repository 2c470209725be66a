#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include "poinsot/cost/cancelled.h"
#include "poinsot/session/thread_job.h"

namespace poinsot::session {
namespace {

std::optional<Outcome> awaited(ThreadJob& job) {
  while (!job.endsWithin(std::chrono::milliseconds(100))) {
  }
  return job.poll();
}

Outcome untilCancelled(const std::atomic<bool>& cancelled) {
  while (!cancelled) std::this_thread::yield();
  throw cost::Cancelled();
}

TEST(ThreadJob, givesItsOutcomeOnce) {
  ThreadJob job;
  EXPECT_FALSE(job.busy());
  EXPECT_FALSE(job.poll());
  job.start([](const std::atomic<bool>&) { return Outcome(Advanced{7, {}}); });
  EXPECT_TRUE(job.busy());
  EXPECT_EQ(std::get<Advanced>(*awaited(job)).time, 7);
  EXPECT_FALSE(job.busy());
  EXPECT_FALSE(job.poll());
}

TEST(ThreadJob, isBusyUntilItIsPolledAlsoWhenItWasCancelled) {
  ThreadJob job;
  job.start(untilCancelled);
  EXPECT_FALSE(job.poll()) << "it never waits";
  job.cancel();
  EXPECT_TRUE(job.busy());
  EXPECT_THROW(awaited(job), cost::Cancelled);
  EXPECT_FALSE(job.busy());
}

TEST(ThreadJob, throwsWhatTheWorkThrewAndCanBeUsedAgain) {
  ThreadJob job;
  job.start([](const std::atomic<bool>&) -> Outcome { throw std::runtime_error("broken"); });
  EXPECT_THROW(awaited(job), std::runtime_error);
  job.start([](const std::atomic<bool>& cancelled) { return Outcome(Advanced{cancelled ? 1.0 : 2.0, {}}); });
  EXPECT_EQ(std::get<Advanced>(*awaited(job)).time, 2);
}

TEST(ThreadJob, endsWhatRunsWhenItIsDestroyed) {
  bool ended = false;
  {
    ThreadJob job;
    job.start([&](const std::atomic<bool>& cancelled) {
      while (!cancelled) std::this_thread::yield();
      ended = true;
      return Outcome(Advanced{});
    });
  }
  EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace poinsot::session
