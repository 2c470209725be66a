// What takes effect at the next tick: pause, step, speed, seeks that are near, and what stamps may do.
#include <cmath>
#include <limits>

#include "played.h"

namespace poinsot::session {
namespace {

using Control = Played;

TEST_F(Control, playsAtRateOne) {
  const double before = session->clock().time();
  EXPECT_NEAR(tick(0.5)->time - before, 0.5, 1e-12);
  EXPECT_EQ(bodyNamed("wing").state().time, session->clock().time());
}

TEST_F(Control, aPauseHoldsAndAStepAdvancesByOnePeriod) {
  EXPECT_EQ(ask(Step{})->refusal->reason, Reason::not_paused);
  EXPECT_FALSE(session->status().refusal) << "the answer says it; nothing that was asked for is lost";
  EXPECT_FALSE(ask(Pause{true})->refusal);
  tick();
  const double held = session->clock().time();
  EXPECT_EQ(tick(1)->time, held);
  EXPECT_FALSE(ask(Step{})->refusal);
  tick(1e-3);
  EXPECT_NEAR(tick(1)->time, held + 0.01, 1e-12);
}

TEST_F(Control, aSceneInRoundsBeginsAgainInANewSegment) {
  scene::Scene scene = twoBodies();
  scene.loop = 2.0;
  play(scene);
  const auto first = segment();
  tick(1.9);
  EXPECT_EQ(segment(), first);
  const auto next = tick(0.2);
  EXPECT_EQ(next->time, 0);
  EXPECT_EQ(segment(), first + 1);
  EXPECT_EQ(bodyNamed("wing").state().time, 0);
  EXPECT_NEAR(tick(0.5)->time, 0.5, 1e-12) << "and goes on";
}

TEST_F(Control, aSceneInRoundsPlaysBackwardsFromItsEnd) {
  scene::Scene scene = twoBodies();
  scene.loop = 2.0;
  play(scene);
  ask(SetSpeed{-1});
  tick(0.01);
  EXPECT_EQ(tick(0.5)->time, 2.0);
  EXPECT_NEAR(tick(0.5)->time, 1.5, 1e-12);
}

TEST_F(Control, aPauseBeyondTheEndOfARoundHolds) {
  scene::Scene scene = twoBodies();
  scene.loop = 2.0;
  play(scene);
  ask(Pause{true});
  ask(Seek{5});
  tick();
  EXPECT_EQ(tick()->time, 5);
}

TEST_F(Control, speedsThatAreNoNumbersAreRefused) {
  for (const double speed : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(ask(SetSpeed{speed})->refusal->reason, Reason::not_finite);
  }
  EXPECT_EQ(session->clock().speed(), 1);
  EXPECT_EQ(heard.refusals.size(), 2u);
  EXPECT_TRUE(session->status().refusal);
  EXPECT_FALSE(ask(SetSpeed{-2})->refusal);
  EXPECT_EQ(session->clock().speed(), -2);
  EXPECT_FALSE(session->status().refusal) << "something was done since";
}

TEST_F(Control, aSpeedThatTheStepsCannotFollowIsRefusedWithWhatIsPossible) {
  ask(SetMethod{"wing", "rk4", 1e-4});
  work();
  const Answer answer = *ask(SetSpeed{1e9});
  ASSERT_TRUE(answer.refusal);
  EXPECT_EQ(answer.refusal->reason, Reason::too_fast);
  EXPECT_NEAR(answer.refusal->limit * answer.refusal->figure, 0.8, 1e-9);
  EXPECT_FALSE(ask(SetSpeed{0.5 * answer.refusal->limit})->refusal) << "what is said to be allowed is";
}

TEST_F(Control, aNearSeekJumpsAtTheNextTickInANewSegment) {
  const std::uint32_t before = segment();
  ask(Seek{-40});
  const Tick there = *tick();
  EXPECT_EQ(there.time, -40);
  EXPECT_EQ(there.segment, before + 1);
  EXPECT_EQ(job.started, 0);
}

TEST_F(Control, seeksThatCannotBeAreRefusedAndChangeNothing) {
  ask(SetMethod{"wing2", "rk4", 1e-3});
  work();
  tick();
  const std::uint32_t before = segment();
  EXPECT_EQ(ask(Seek{std::nan("")})->refusal->reason, Reason::not_finite);
  const Answer far = *ask(Seek{1e7});
  ASSERT_TRUE(far.refusal);
  EXPECT_EQ(far.refusal->reason, Reason::too_many_steps);
  EXPECT_EQ(far.refusal->body, "wing2");
  EXPECT_EQ(far.refusal->method, "rk4");
  EXPECT_NEAR(far.refusal->figure, 1e10, 1e5);
  tick();
  EXPECT_EQ(segment(), before);
}

TEST_F(Control, whereDoublesLieFarApartItIsSaid) {
  ask(Seek{1e15});
  EXPECT_EQ(heard.coarse, 1);
  ask(Seek{1});
  EXPECT_EQ(heard.coarse, 1);
}

TEST_F(Control, stampsThatJumpBackBeginASegmentAtTheSameTime) {
  tick(1);
  const double time = session->clock().time();
  const std::uint32_t before = segment();
  stamp -= 500 * kSecond;
  const Tick after = *tick();
  EXPECT_EQ(heard.jumps_back, 1);
  EXPECT_EQ(after.time, time);
  EXPECT_EQ(after.segment, before + 1);
}

TEST_F(Control, stampsThatJumpTooFarAheadToStepAreNotFollowed) {
  ask(SetMethod{"wing", "rk4", 1e-4});
  work();
  tick();
  const double time = session->clock().time();
  tick(1e4);  // 1e8 steps
  ASSERT_EQ(heard.jumps_ahead.size(), 1u);
  EXPECT_NEAR(heard.jumps_ahead[0], 1e4, 1);
  EXPECT_NEAR(session->clock().time(), time, 1e-9);
}

TEST_F(Control, whereTimeLeavesTheRangeOfDoublesItPauses) {
  ask(SetSpeed{1e308});
  tick();
  tick(100);
  EXPECT_EQ(heard.left_range, 1);
  EXPECT_TRUE(session->clock().paused());
  EXPECT_TRUE(std::isfinite(session->clock().time()));
}

TEST_F(Control, statusIsTyped) {
  const Status status = session->status();
  EXPECT_EQ(status.scene, "first");
  EXPECT_TRUE(status.activities.empty());
  ASSERT_EQ(status.bodies.size(), 2u);
  ASSERT_TRUE(status.bodies[0].free);
  EXPECT_EQ(status.bodies[0].free->regime, bodyNamed("wing").regime());
  EXPECT_TRUE(status.bodies[0].free->flips.flips);
  EXPECT_FALSE(status.bodies[0].step);
}

}  // namespace
}  // namespace poinsot::session
