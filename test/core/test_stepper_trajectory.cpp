#include "poinsot/core/method.h"
#include "poinsot/core/stepper_trajectory.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "draws.h"

namespace poinsot {
namespace {

const Eigen::Vector3d kMoments(1, 2, 3);

StepperTrajectory trajectory(const char* method = "buss2", double step = 1e-3) {
  return {findMethod(method)->make(kMoments),
          RotationState::fromOmega(kMoments, Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5), {0.01, 1, 0.02}), step};
}

/** n steps from the start, in one go. */
RotationState direct(std::int64_t n, const char* method = "buss2", double step = 1e-3) {
  RotationState state = RotationState::fromOmega(kMoments, Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5), {0.01, 1, 0.02});
  findMethod(method)->make(kMoments)->advance(state, 0, step, n);
  return state;
}

bool same(const RotationState& a, const RotationState& b) {
  return a.attitude.coeffs() == b.attitude.coeffs() && a.momentum_principal == b.momentum_principal;
}

TEST(StepperTrajectory, stateDoesNotDependOnHowOneGotThere) {
  for (const Method& method : freeMethods()) {
    for (const double step : {1e-3, -1e-3}) {
      StepperTrajectory forward = trajectory(method.name, step), other = trajectory(method.name, step);
      std::vector<RotationState> states;
      for (std::int64_t n = 0; n < 5000; ++n) states.push_back(forward.at(n));
      EXPECT_TRUE(same(states[4999], direct(4999, method.name, step)));
      for (std::int64_t n = 4999; n >= 0; --n) ASSERT_TRUE(same(forward.at(n), states[n])) << method.name << " " << n;
      std::mt19937 random(5);
      for (int i = 0; i < 3000; ++i) {
        const std::int64_t n = random() % 5000;
        ASSERT_TRUE(same(other.at(n), states[n])) << method.name << " " << n;
      }
    }
  }
}

TEST(StepperTrajectory, nothingIsLostWhenCheckpointsAreThinned) {
  // Checkpoints are 1024 steps apart and thinned when there are 16384 of them.
  const std::int64_t far = std::int64_t{16384} * 1024 + 12345;
  StepperTrajectory path = trajectory();
  std::mt19937_64 random(5);
  std::vector<std::pair<std::int64_t, RotationState>> noted;
  for (std::int64_t n = 0; n < far; n += 999983) noted.emplace_back(n, path.at(n));
  EXPECT_TRUE(same(path.at(far), direct(far)));
  for (auto it = noted.rbegin(); it != noted.rend(); ++it) EXPECT_TRUE(same(path.at(it->first), it->second));
  std::shuffle(noted.begin(), noted.end(), random);
  for (const auto& [n, state] : noted) {
    EXPECT_LE(path.stepsTo(n), 4096);  // memory is bounded, the way back stays short
    EXPECT_TRUE(same(path.at(n), state));
  }
  EXPECT_TRUE(same(path.at(far + 5000), direct(far + 5000)));
}

TEST(StepperTrajectory, playingBackwardsIsCheap) {
  StepperTrajectory path = trajectory();
  path.at(100000);
  std::int64_t steps = 0;
  for (std::int64_t n = 100000; n > 50000; n -= 16) {
    steps += path.stepsTo(n);
    path.at(n);
  }
  // Without notes inside an interval each of the 3125 visits would take 512 steps on average.
  EXPECT_LT(steps, 3125 * 80);
}

TEST(StepperTrajectory, playingBackwardsFromTheFurthestPointIsCheap) {
  StepperTrajectory path = trajectory();
  path.at(1023);  // no checkpoint but the start
  std::int64_t steps = 0;
  for (std::int64_t n = 1023; n > 0; --n) {
    steps += path.stepsTo(n);
    path.at(n);
  }
  EXPECT_LT(steps, 1023 * 40);
}

TEST(StepperTrajectory, stepsToCountsTheWork) {
  StepperTrajectory path = trajectory();
  EXPECT_EQ(path.stepsTo(0), 0);
  EXPECT_EQ(path.stepsTo(5000), 5000);
  path.at(5000);
  EXPECT_EQ(path.stepsTo(5000), 0);
  EXPECT_EQ(path.stepsTo(5001), 1);
  EXPECT_EQ(path.stepsTo(4096 + 7), 7);
  EXPECT_EQ(path.stepsTo(3), 3);
}

TEST(StepperTrajectory, copiesAreIndependent) {
  StepperTrajectory a = trajectory();
  a.at(3000);
  StepperTrajectory b = a;
  b.at(10000);
  EXPECT_EQ(a.stepsTo(10000), 7000);
  EXPECT_TRUE(same(a.at(3000), direct(3000)));
  EXPECT_TRUE(same(b.at(4000), direct(4000)));
}

TEST(StepperTrajectory, cancelStopsSoonAndKeepsWhatWasReached) {
  StepperTrajectory path = trajectory();
  std::atomic<bool> cancel{true};
  EXPECT_FALSE(path.moveTo(1000000, cancel));
  EXPECT_EQ(path.stepsTo(1000000), 1000000);

  cancel = false;
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    cancel = true;
  });
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(path.moveTo(std::int64_t{1} << 50, cancel));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
  later.join();
  const std::int64_t left = path.stepsTo(std::int64_t{1} << 50);
  EXPECT_LT(left, std::int64_t{1} << 50);
  cancel = false;
  EXPECT_TRUE(path.moveTo(20000, cancel));
  EXPECT_TRUE(same(path.at(20000), direct(20000)));
}

}  // namespace
}  // namespace poinsot
