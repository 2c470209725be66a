// What is worked out in the background: which requests go together, which end each other, and what is refused.
#include <algorithm>

#include "played.h"
#include "poinsot/scene/reader.h"

namespace poinsot::session {
namespace {

using Work = Played;

/** The kinds of what is being worked out, by their places in Request. */
std::vector<std::size_t> kinds(const std::vector<Request>& requests) {
  std::vector<std::size_t> out;
  for (const Request& request : requests) out.push_back(request.index());
  return out;
}

const std::size_t kLoad = Request(LoadScene{}).index(), kMethod = Request(SetMethod{}).index(),
                  kSpin = Request(SetSpin{}).index(), kReset = Request(Reset{}).index(),
                  kSeek = Request(Seek{}).index();

TEST_F(Work, aMethodIsAnsweredWhenItWasChosenAndPlaysWhenItIsReady) {
  tick(1);
  const double time = session->clock().time();
  EXPECT_FALSE(ask(SetMethod{"wing", "rk4", {}})) << "its step takes trials: not in this thread";
  workOnce();
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].method, "rk4");
  EXPECT_GT(answers[0].step.value(), 0);
  EXPECT_EQ(methodOf("wing"), "closed_form") << "not before it is ready";
  EXPECT_EQ(kinds(session->status().activities), std::vector<std::size_t>{kMethod});
  const std::uint32_t before = segment();
  workOnce();
  EXPECT_EQ(methodOf("wing"), "rk4");
  EXPECT_EQ(methodOf("wing2"), "closed_form");
  EXPECT_EQ(heard.changes, std::vector<bool>{false});
  EXPECT_TRUE(session->status().activities.empty());
  const Tick next = *tick();
  EXPECT_EQ(next.segment, before + 1);
  EXPECT_NEAR(next.time, time + 0.01, 1e-12) << "t goes on";
}

TEST_F(Work, aBadMethodIsRefusedAloneAndNothingChanges) {
  ask(SetMethod{"wing", "rk5", {}});
  ask(SetMethod{"nobody", "rk4", {}});
  work();
  EXPECT_EQ(heard.refusals.size(), 2u);
  EXPECT_NE(heard.refusals[1].detail.find("wing, wing2"), std::string::npos) << heard.refusals[1].detail;
  EXPECT_TRUE(heard.changes.empty());
  EXPECT_EQ(methodOf("wing"), "closed_form");
}

TEST_F(Work, aBadRequestDoesNotTouchTheGoodOneBesideIt) {
  ask(SetMethod{"wing", "rk4", 0.01});
  ask(SetMethod{"wing2", "rk5", {}});
  work();
  EXPECT_EQ(methodOf("wing"), "rk4");
  EXPECT_EQ(heard.refusals.size(), 1u);
}

TEST_F(Work, theLastOfSeveralMethodsCounts) {
  for (const char* method : {"rk4", "buss2", "lie_euler", "rk4", "buss4"}) ask(SetMethod{"wing", method, 0.01});
  work();
  EXPECT_EQ(methodOf("wing"), "buss4");
  EXPECT_EQ(heard.changes.size(), 1u) << "what has been overtaken does not play in between";
}

TEST_F(Work, whatIsOvertakenWhileItIsBuiltIsGivenUp) {
  ask(SetMethod{"wing", "rk4", 0.01});
  workOnce();  // prepared, and building
  ASSERT_TRUE(job.busy());
  ask(SetSpin{"wing2", {3, 0, 0}});
  EXPECT_TRUE(job.isCancelled());
  work();
  EXPECT_EQ(methodOf("wing"), "rk4") << "both are done";
  EXPECT_EQ(bodyNamed("wing2").state().omega_body, Eigen::Vector3d(3, 0, 0));
  EXPECT_EQ(heard.changes.size(), 1u);
  EXPECT_TRUE(heard.refusals.empty());
}

TEST_F(Work, spinsOfTwoBodiesAreBothDoneHoweverTheirNamesBegin) {
  ask(SetSpin{"wing2", {0, 0, 2}});
  ask(SetSpin{"wing", {2, 0, 0}});
  ask(SetSpin{"wing", {4, 0, 0}});
  EXPECT_EQ(kinds(session->status().activities), (std::vector<std::size_t>{kSpin, kSpin})) << "one a body";
  work();
  EXPECT_EQ(bodyNamed("wing").state().omega_body.x(), 4);
  EXPECT_EQ(bodyNamed("wing2").state().omega_body.z(), 2);
}

TEST_F(Work, aSpinIsAnsweredAtOnceAndStartsWhereTheBodyIs) {
  tick(2);
  const Eigen::Quaterniond attitude = bodyNamed("wing").state().attitude;
  const std::optional<Answer> answer = ask(SetSpin{"wing", {0, 5, 0}});
  ASSERT_TRUE(answer);
  EXPECT_FALSE(answer->refusal);
  tick(3);  // it goes on meanwhile
  work();
  EXPECT_EQ(tick()->time, 0) << "t = 0 for the whole scene";
  EXPECT_LT(bodyNamed("wing").state().attitude.angularDistance(attitude), 1e-12);
  EXPECT_LT(bodyNamed("wing2").state().attitude.angularDistance(Eigen::Quaterniond::Identity()), 1e-12);
}

TEST_F(Work, aForbiddenSpinIsRefusedAtOnce) {
  const std::optional<Answer> answer = ask(SetSpin{"wing", {NAN, 0, 0}});
  ASSERT_TRUE(answer && answer->refusal);
  EXPECT_FALSE(job.busy());
}

TEST_F(Work, resetBringsTheStartBackAndLeavesTheMethod) {
  ask(SetMethod{"wing", "rk4", 0.01});
  ask(SetSpin{"wing", {3, 0, 0}});
  work();
  const Answer answer = *ask(Reset{});
  EXPECT_TRUE(answer.in_the_background);
  EXPECT_TRUE(answer.spins);
  work();
  EXPECT_EQ(methodOf("wing"), "rk4");
  EXPECT_EQ(bodyNamed("wing").motion().setup().omega_body, body("wing").omega_body);
  EXPECT_EQ(redraws.back(), Redraw::always);
  EXPECT_EQ(tick()->time, 0);
  EXPECT_FALSE(ask(Reset{})->in_the_background) << "there is nothing to bring back any more";
}

TEST_F(Work, resetEndsASpinThatIsStillBeingMade) {
  ask(SetSpin{"wing", {3, 0, 0}});
  ask(Reset{});
  EXPECT_EQ(kinds(session->status().activities), std::vector<std::size_t>{kReset});
  work();
  EXPECT_EQ(bodyNamed("wing").motion().setup().omega_body, body("wing").omega_body);
}

TEST_F(Work, resetDoesNotWaitForAMethod) {
  tick(5);
  ask(SetMethod{"wing", "rk4", 0.01});
  workOnce();
  ask(Reset{});
  work();
  EXPECT_EQ(methodOf("wing"), "rk4");
  EXPECT_EQ(tick()->time, 0);
}

TEST_F(Work, anotherSceneTakesTheWholePlace) {
  to_read.bodies = {body("other")};
  tick(3);
  EXPECT_FALSE(ask(LoadScene{"second"})) << "answered when it was read";
  EXPECT_EQ(kinds(session->status().activities), std::vector<std::size_t>{kLoad});
  workOnce();
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].scene, "second");
  EXPECT_EQ(session->bodies().size(), 2u);
  work();
  ASSERT_EQ(session->bodies().size(), 1u);
  EXPECT_EQ(heard.changes, std::vector<bool>{true});
  EXPECT_EQ(session->status().scene, "second");
  EXPECT_EQ(session->status().file, "/second.yaml");
  EXPECT_EQ(tick()->time, 0);
}

TEST_F(Work, aSceneThatCannotBeReadChangesNothing) {
  EXPECT_EQ(ask(LoadScene{"none"})->refusal->detail, "there is no scene \"none\"") << "at sight";
  ask(LoadScene{"bad"});
  work();
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].refusal->detail, "line 1: not a scene");
  EXPECT_EQ(session->status().scene, "first");
  EXPECT_TRUE(heard.changes.empty());
}

TEST_F(Work, theLastOfSeveralScenesPlaysAndEachIsAnswered) {
  ask(LoadScene{"a"});
  std::vector<std::string> answered;
  for (const char* name : {"b", "c"}) {
    session->ask(LoadScene{name}, [&](const Answer& answer) { answered.push_back(answer.scene); });
  }
  work();
  EXPECT_EQ(session->status().scene, "c");
  EXPECT_EQ(answered, (std::vector<std::string>{"b", "c"}));
}

TEST_F(Work, methodsAndSpinsWaitForTheSceneThatIsBeingMadeReady) {
  ask(LoadScene{"second"});
  EXPECT_TRUE(ask(SetMethod{"wing", "rk4", {}})->refusal);
  EXPECT_TRUE(ask(SetSpin{"wing", {1, 0, 0}})->refusal);
  EXPECT_FALSE(ask(Seek{7})->refusal) << "what plays can be sent elsewhere";
  EXPECT_EQ(tick()->time, 7);
  work();
  EXPECT_EQ(session->status().scene, "second");
  EXPECT_EQ(tick()->time, 0);
}

TEST_F(Work, anEmptyNameReadsThePresentFileAgain) {
  ask(LoadScene{""});
  work();
  EXPECT_EQ(heard.changes, std::vector<bool>{true});
  EXPECT_EQ(session->status().file, "/first.yaml");
}

TEST_F(Work, aFarSeekGoesOnInTheBackground) {
  ask(SetMethod{"wing", "rk4", 1e-3});
  work();
  tick();
  ask(Seek{1000});
  EXPECT_EQ(heard.far_seeks, std::vector<double>{1000});
  EXPECT_EQ(kinds(session->status().activities), std::vector<std::size_t>{kSeek});
  tick();
  EXPECT_LT(session->clock().time(), 1) << "it plays on meanwhile";
  work();
  EXPECT_EQ(tick()->time, 1000);
  EXPECT_TRUE(session->status().activities.empty());
}

TEST_F(Work, aNewSeekEndsTheOneBefore) {
  ask(SetMethod{"wing", "rk4", 1e-3});
  work();
  ask(Seek{1000});
  ask(Seek{900});
  EXPECT_TRUE(job.isCancelled());
  work();
  EXPECT_EQ(tick()->time, 900);
  ask(Seek{1000});
  ask(Seek{900.5});
  work();
  EXPECT_EQ(tick()->time, 900.5);
  EXPECT_TRUE(heard.refusals.empty());
}

TEST_F(Work, aFarSeekOutlivesAnotherMethod) {
  ask(SetMethod{"wing", "rk4", 1e-3});
  work();
  ask(Seek{1000});
  ask(SetMethod{"wing", "buss2", 1e-3});
  work();
  EXPECT_EQ(methodOf("wing"), "buss2");
  EXPECT_EQ(tick()->time, 1000);
  EXPECT_NEAR(bodyNamed("wing").state().time, 1000, 1e-9);
}

TEST_F(Work, aSeekAfterASpinWaitsForItAndOneBeforeItIsOver) {
  ask(SetMethod{"wing", "rk4", 1e-3});
  work();
  ask(Seek{1000});
  ask(SetSpin{"wing", {2, 0, 0}});
  ask(Seek{1.5});
  work();
  EXPECT_EQ(bodyNamed("wing").motion().setup().omega_body.x(), 2);
  EXPECT_EQ(tick()->time, 1.5);
  ask(Seek{1000});
  ask(SetSpin{"wing", {3, 0, 0}});
  work();
  EXPECT_EQ(tick()->time, 0);
}

TEST_F(Work, aMethodIsMadeReadyForTheTimeThatHasComeMeanwhile) {
  ask(SetMethod{"wing", "lie_euler", 1e-4});
  workOnce();      // prepared
  ask(Seek{510});  // closed form: at once
  tick();
  workOnce();  // built for the time before: 5.1e6 steps are missing
  EXPECT_EQ(methodOf("wing"), "closed_form");
  ASSERT_TRUE(job.busy()) << "it is stepped on in the background, not in a tick";
  work();
  EXPECT_EQ(methodOf("wing"), "lie_euler");
  EXPECT_NEAR(tick()->time, 510, 0.1);
}

TEST_F(Work, aSeekThatWouldStepTooFarAfterASpinIsRefusedAndNotDone) {
  ask(SetMethod{"wing", "rk4", 1e-3});
  work();
  ask(SetSpin{"wing", {2, 0, 0}});
  EXPECT_FALSE(ask(Seek{1e7})->refusal) << "it waits for the spin";
  work();
  ASSERT_EQ(heard.refusals.size(), 1u);
  EXPECT_EQ(heard.refusals[0].reason, Reason::too_many_steps);
  EXPECT_FALSE(job.busy());
  EXPECT_TRUE(session->status().activities.empty());
  EXPECT_EQ(tick()->time, 0);
}

TEST_F(Work, seeksDoNotHoldUpTheSpinBeforeThem) {
  ask(SetSpin{"wing", {2, 0, 0}});
  const int started = job.started;
  for (int i = 0; i < 5; ++i) ask(Seek{1.0 + i});
  EXPECT_FALSE(job.isCancelled());
  work();
  EXPECT_EQ(job.started, started);
  EXPECT_EQ(tick()->time, 5);
}

TEST_F(Work, whatIsRefusedAtSightLeavesWorkUnderWayAlone) {
  ask(SetMethod{"wing", "rk4", 1e-3});
  work();
  ask(Seek{1000});
  EXPECT_TRUE(ask(SetMethod{"wing", "rk5", {}})->refusal);
  EXPECT_TRUE(ask(SetMethod{"nobody", "rk4", {}})->refusal);
  EXPECT_TRUE(ask(LoadScene{"none"})->refusal);
  EXPECT_FALSE(job.isCancelled());
  work();
  EXPECT_EQ(tick()->time, 1000);
}

TEST_F(Work, aFarSeekOutlivesASpinThatCannotBeMade) {
  ask(SetMethod{"wing", "rk4", 1e-3});
  work();
  ask(Seek{1000});
  ask(SetMethod{"wing2", "rk4", 1e-9});  // costs too much
  work();
  EXPECT_EQ(heard.refusals.size(), 1u);
  EXPECT_EQ(tick()->time, 1000);
}

TEST_F(Work, aStartAtZeroIsNoJumpThatIsTooFarToStep) {
  ask(SetMethod{"wing", "lie_euler", 1e-4});
  work();
  tick();
  ask(Seek{510});
  work();
  tick();
  ask(SetSpin{"wing", {2, 0, 0}});
  work();
  EXPECT_EQ(tick()->time, 0);
  EXPECT_TRUE(heard.jumps_ahead.empty());
}

TEST_F(Work, whatWasOvertakenAfterItHasEndedDoesNotPlayEither) {
  ask(SetMethod{"wing", "rk4", 0.01});
  workOnce();  // prepared
  job.endNow();
  ask(SetMethod{"wing", "buss2", 0.01});
  work();
  EXPECT_EQ(methodOf("wing"), "buss2");
  EXPECT_EQ(heard.changes.size(), 1u);
}

TEST_F(Work, aMethodThatWouldStepTooFarIsRefused) {
  ask(Seek{1e8});
  tick();
  ask(SetMethod{"wing", "rk4", 1e-3});
  work();
  ASSERT_EQ(heard.refusals.size(), 1u);
  EXPECT_NE(heard.refusals[0].detail.find("1e+11 steps"), std::string::npos) << heard.refusals[0].detail;
}

TEST_F(Work, stepsThatCostTooMuchAreRefusedWithAllThatWasAskedForWithThem) {
  ask(SetSpin{"wing", {0, 3, 0}});
  ask(SetMethod{"wing2", "rk4", 1e-9});  // tens of CPU s per simulated s on any machine
  work();
  ASSERT_EQ(heard.refusals.size(), 1u);
  EXPECT_EQ(heard.refusals[0].reason, Reason::too_fast);
  EXPECT_GT(heard.refusals[0].figure, 0.8);
  EXPECT_EQ(kinds(heard.refusals[0].requests), (std::vector<std::size_t>{kSpin, kMethod}));
  EXPECT_TRUE(heard.changes.empty());
  EXPECT_FALSE(job.busy());
}

TEST_F(Work, anAccuracyOutOfReachIsRefusedWhenItWasLookedFor) {
  to_read.bodies = {body("other")};
  to_read.bodies[0].accuracy = scene::Accuracy{1e-14, 1e6, {"lie_euler"}, false, "other: "};
  ask(LoadScene{"second"});
  workOnce();
  EXPECT_FALSE(answers[0].refusal) << "the scene was read and found good";
  work();
  ASSERT_EQ(heard.refusals.size(), 1u);
  EXPECT_EQ(heard.refusals[0].reason, Reason::cannot_be_made);
  EXPECT_EQ(session->status().scene, "first");
}

TEST_F(Work, accuraciesAreMetInTheBackgroundAndSaid) {
  to_read.bodies = {body("other")};
  to_read.bodies[0].accuracy = scene::Accuracy{1e-6, 10, {"rk4"}, false, "other: "};
  ask(LoadScene{"second"});
  work();
  EXPECT_EQ(methodOf("other"), "rk4");
  ASSERT_EQ(heard.choices.size(), 1u);
}

}  // namespace
}  // namespace poinsot::session
