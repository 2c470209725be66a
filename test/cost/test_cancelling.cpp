// What takes long can be given up. Judged by CPU time, which does not depend on what else the machine does.
#include <gtest/gtest.h>
#include <pthread.h>
#include <time.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "poinsot/core/method.h"
#include "poinsot/cost/cancelled.h"
#include "poinsot/cost/choice.h"
#include "poinsot/cost/cpu_time.h"

using namespace poinsot;

namespace {

constexpr double kPrompt = 0.3;  // s of CPU time

MotionSetup spinning(double rate) {
  MotionSetup setup;
  setup.inertia = PrincipalInertia::fromMoments({1, 1.7, 2.1});
  setup.omega_body = rate * Eigen::Vector3d(0.6, -0.5, 0.7);
  return setup;
}

/** CPU seconds that `search` goes on for after it was told to give up, having worked for `working` CPU seconds. */
template <class Search>
double secondsToGiveUp(double working, const Search& search) {
  std::atomic<bool> cancel{false}, gave_up{false}, looked{false};
  std::atomic<double> end{0};
  std::thread worker([&] {
    try {
      search(cancel);
    } catch (const cost::Cancelled&) {
      gave_up = true;
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
    end = cost::threadCpuTime();
    while (!looked) std::this_thread::yield();  // its clock is read below
  });
  clockid_t clock;
  EXPECT_EQ(pthread_getcpuclockid(worker.native_handle(), &clock), 0);
  const auto worked = [&] {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  };
  while (worked() < working && end == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  cancel = true;
  const double begin =
      worked();  // after it: what the worker does while this thread waits for a processor does not count
  looked = true;
  worker.join();
  EXPECT_TRUE(gave_up) << "it had ended before";
  return end - begin;
}

TEST(Cancelling, aSearchUnderTorquesGivesUp) {
  MotionSetup top = spinning(20);
  top.effects = {GravityTorque{1, {0, 0, -9.8}, {0, 0, 0.4}}};
  for (const double working : {0.01, 0.2, 1.0}) {
    const double took = secondsToGiveUp(working, [&](const std::atomic<bool>& cancel) {
      cost::choose(top, {1e-9, 30000, 60, {"taylor8", "taylor24", "rk4", "aba84"}}, cost::nominalCosts(), cancel);
    });
    EXPECT_LT(took, kPrompt) << "after " << working << " s of work";
  }
}

TEST(Cancelling, aSearchForAFreeBodyGivesUp) {
  for (const double working : {0.01, 0.2, 1.0}) {
    const double took = secondsToGiveUp(working, [&](const std::atomic<bool>& cancel) {
      cost::choose(spinning(1), {1e-6, 1e5, 60, {"splitting6", "rk4", "midpoint"}}, cost::nominalCosts(), cancel);
    });
    EXPECT_LT(took, kPrompt) << "after " << working << " s of work";
  }
}

TEST(Cancelling, nothingIsBegunThatIsCancelledAlready) {
  const std::atomic<bool> cancel{true};
  EXPECT_THROW(cost::choose(spinning(1), {1e-6, 100, 60, {"rk4"}}, cost::nominalCosts(), cancel), cost::Cancelled);
}

}  // namespace
