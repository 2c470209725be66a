#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include "poinsot/ros/fair_mutex.h"

namespace poinsot::node {
namespace {

void work() {
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(2);
  while (std::chrono::steady_clock::now() < until) {
  }
}

TEST(FairMutex, whoNeverPausesLetsOthersInAfterOneTurn) {
  FairMutex mutex;
  std::atomic<int> turns{0};
  std::atomic<bool> stop{false};
  std::thread busy([&] {
    while (!stop) {
      const std::lock_guard<FairMutex> lock(mutex);
      work();
      ++turns;
    }
  });
  while (turns == 0) std::this_thread::yield();
  for (int i = 0; i < 100; ++i) {
    const std::lock_guard<FairMutex> lock(mutex);
    const int before = turns;
    work();
    EXPECT_EQ(turns, before) << "two had it at once";
  }
  const int turns_of_busy = turns;
  stop = true;
  busy.join();
  // One turn each, but for those between unlock() and the next lock().
  EXPECT_LT(turns_of_busy, 2000);
}

TEST(FairMutex, excludes) {
  FairMutex mutex;
  int counter = 0;
  const auto count = [&] {
    for (int i = 0; i < 20000; ++i) {
      const std::lock_guard<FairMutex> lock(mutex);
      ++counter;
    }
  };
  std::thread a(count), b(count);
  a.join();
  b.join();
  EXPECT_EQ(counter, 40000);
}

}  // namespace
}  // namespace poinsot::node
