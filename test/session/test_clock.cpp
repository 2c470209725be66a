#include <gtest/gtest.h>

#include <cmath>

#include "poinsot/session/clock.h"

namespace {

using poinsot::session::Clock;
using poinsot::session::kSecond;
using poinsot::session::Nanoseconds;
using poinsot::session::Tick;

constexpr double kStep = 1.0 / 60;

Nanoseconds at(double seconds) {
  return 1000 * kSecond + std::llround(1e9 * seconds);
}

TEST(Clock, RunsWithTheStamps) {
  Clock clock(kStep);
  const Tick first = *clock.tick(at(0));
  EXPECT_EQ(first.time, 0);
  EXPECT_EQ(first.time_rate, 1);
  EXPECT_EQ(first.segment, 0u);
  EXPECT_NEAR(clock.tick(at(0.5))->time, 0.5, 1e-12);
}

TEST(Clock, SendsNothingForARepeatedOrEarlierStamp) {
  Clock clock(kStep);
  clock.tick(at(1));
  EXPECT_FALSE(clock.tick(at(1)));
  EXPECT_FALSE(clock.tick(at(0.5)));
  EXPECT_TRUE(clock.jumpedBack(at(0.5)));
  EXPECT_FALSE(clock.jumpedBack(at(1)));
}

TEST(Clock, CommandsTakeEffectAtATickAndNotBefore) {
  Clock clock(kStep);
  clock.tick(at(0));
  clock.setSpeed(-2);
  const Tick turned = *clock.tick(at(1));
  EXPECT_NEAR(turned.time, 1, 1e-12);  // ran at the rate that the last tick stated
  EXPECT_EQ(turned.time_rate, -2);
  EXPECT_NEAR(clock.tick(at(2))->time, -1, 1e-12);
  clock.pause(true);
  EXPECT_EQ(clock.tick(at(3))->time_rate, 0);
  EXPECT_EQ(clock.tick(at(4))->time, -3);
}

TEST(Clock, AStepEndsOnItsEndExactly) {
  Clock clock(kStep);
  clock.pause(true);
  clock.tick(at(0));
  clock.step();
  const Tick start = *clock.tick(at(1));
  EXPECT_EQ(start.time_rate, 1);
  const Tick between = *clock.tick(at(1.01));
  EXPECT_EQ(between.time_rate, 1);
  EXPECT_NEAR(between.time, 0.01, 1e-12);
  const Tick end = *clock.tick(at(1.03));
  EXPECT_EQ(end.stamp, at(1) + std::llround(1e9 * kStep));
  EXPECT_EQ(end.time, kStep);
  EXPECT_EQ(end.time_rate, 0);
  EXPECT_EQ(end.segment, 0u);
  EXPECT_EQ(clock.tick(at(1.04))->time, kStep);
}

TEST(Clock, StepsAddUpAndAreIgnoredWhilePlaying) {
  Clock clock(kStep);
  clock.pause(true);
  clock.tick(at(0));
  for (int i = 0; i < 3; ++i) clock.step();
  Tick tick = *clock.tick(at(0.001));
  for (int i = 1; i < 20; ++i) tick = *clock.tick(at(0.001 + 0.01 * i));
  EXPECT_EQ(tick.time_rate, 0);
  EXPECT_NEAR(tick.time, 3 * kStep, 1e-15);
  clock.pause(false);
  clock.step();
  EXPECT_EQ(clock.tick(at(1))->time_rate, 1);
  clock.pause(true);
  clock.tick(at(2));
  EXPECT_EQ(clock.tick(at(3))->time_rate, 0);
}

TEST(Clock, AJumpBeginsASegment) {
  Clock clock(kStep);
  clock.tick(at(0));
  clock.jumpTo(-40);
  const Tick tick = *clock.tick(at(1));
  EXPECT_EQ(tick.time, -40);
  EXPECT_EQ(tick.segment, 1u);
  EXPECT_NEAR(clock.tick(at(2))->time, -39, 1e-12);
  EXPECT_EQ(clock.tick(at(3))->segment, 1u);
}

TEST(Clock, GoesOnFromWhereItIsAfterTheStampsRestart) {
  Clock clock(kStep);
  clock.tick(at(0));
  clock.tick(at(5));
  clock.restartStamps();
  const Tick tick = *clock.tick(at(-100));
  EXPECT_NEAR(tick.time, 5, 1e-12);
  EXPECT_EQ(tick.segment, 1u);
  EXPECT_NEAR(clock.tick(at(-99))->time, 6, 1e-12);
}

}  // namespace
