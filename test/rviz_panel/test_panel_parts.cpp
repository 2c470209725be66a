// The parts of the panel that have logic of their own, without ROS and without a window.
#include <gtest/gtest.h>
#include <rviz/yaml_config_reader.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <thread>

#include "asked_time.h"
#include "banner.h"
#include "hidden_parts.h"
#include "history.h"
#include "method_words.h"
#include "momentum_camera.h"
#include "poinsot/core/closed_form.h"
#include "poinsot/core/method.h"
#include "regime_text.h"
#include "scene_views.h"
#include "speed_scale.h"
#include "status.h"
#include "text.h"
#include "time_page.h"
#include "worker.h"

namespace {

using namespace poinsot::rviz_panel;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(SpeedScale, endsAndMiddle) {
  EXPECT_DOUBLE_EQ(speed_scale::speedAt(0), 0.01);
  EXPECT_EQ(speed_scale::speedAt(speed_scale::kPositions / 2), 1);
  EXPECT_DOUBLE_EQ(speed_scale::speedAt(speed_scale::kPositions), 100);
  EXPECT_EQ(speed_scale::speedAt(-5), speed_scale::speedAt(0));
  EXPECT_EQ(speed_scale::speedAt(100000), speed_scale::speedAt(speed_scale::kPositions));
}

TEST(SpeedScale, equalWaysAreEqualFactors) {
  const double factor = speed_scale::speedAt(1) / speed_scale::speedAt(0);
  EXPECT_GT(factor, 1);
  for (int i = 1; i < speed_scale::kPositions; ++i) {
    EXPECT_NEAR(speed_scale::speedAt(i + 1) / speed_scale::speedAt(i), factor, 1e-12) << i;
  }
}

TEST(SpeedScale, positionsComeBack) {
  for (int i = 0; i <= speed_scale::kPositions; ++i) {
    EXPECT_EQ(speed_scale::positionOf(speed_scale::speedAt(i)), i);
    EXPECT_EQ(speed_scale::positionOf(-speed_scale::speedAt(i)), i);
  }
}

TEST(SpeedScale, whatIsNotOnTheSliderIsAtAnEnd) {
  for (const double slow : {0.0, 1e-9, kNaN}) EXPECT_EQ(speed_scale::positionOf(slow), 0) << slow;
  for (const double fast : {1e3, -1e9, kInfinity}) {
    EXPECT_EQ(speed_scale::positionOf(fast), speed_scale::kPositions) << fast;
  }
}

TEST(TimePage, staysWhereTIsOnIt) {
  TimePage page(60);
  for (const double t : {0.0, 30.0, 60.0}) {
    page.turnTo(t);
    EXPECT_EQ(page.from(), 0) << t;
    EXPECT_EQ(page.to(), 60) << t;
  }
}

TEST(TimePage, turnsToWhereTIs) {
  TimePage page(60);
  page.turnTo(61);
  EXPECT_EQ(page.from(), 60);
  page.turnTo(-1);
  EXPECT_EQ(page.from(), -60);
  EXPECT_EQ(page.to(), 0);
  page.turnTo(1e9 + 1);
  EXPECT_LE(page.from(), 1e9 + 1);
  EXPECT_GE(page.to(), 1e9 + 1);
  const double before = page.from();
  for (const double bad : {kNaN, kInfinity, -kInfinity}) page.turnTo(bad);
  EXPECT_EQ(page.from(), before);
}

TEST(TimePage, bothSides) {
  TimePage page(10, true);
  EXPECT_EQ(page.from(), -10);
  EXPECT_EQ(page.to(), 10);
  page.turnTo(11);
  EXPECT_EQ(page.from(), 10);
  EXPECT_EQ(page.to(), 30);
}

TEST(TimePage, sharesAndTimes) {
  TimePage page(10, true);
  for (const double share : {0.0, 0.25, 1.0}) EXPECT_DOUBLE_EQ(page.shareAt(page.timeAt(share)), share);
  EXPECT_EQ(page.shareAt(-1e300), 0);
  EXPECT_EQ(page.shareAt(kInfinity), 1);
  EXPECT_EQ(page.shareAt(kNaN), 0);
}

TEST(AskedTime, hidesWhatIsFromBeforeTheJump) {
  AskedTime asked;
  EXPECT_FALSE(asked.hides(4, false, 0)) << "nothing was asked for";
  asked.ask(10);
  EXPECT_TRUE(asked.hides(4, false, 10.1));
  EXPECT_FALSE(asked.hides(5, false, 10.2)) << "the node is there";
  EXPECT_TRUE(asked.hides(4, false, 10.3)) << "a message that came late";
  EXPECT_FALSE(asked.hides(5, false, 10.4));
}

TEST(AskedTime, waitsForANodeThatSeeks) {
  AskedTime asked;
  asked.hides(4, false, 0);
  asked.ask(10);
  for (double now = 10; now < 60; now += 0.5) EXPECT_TRUE(asked.hides(4, true, now)) << now;
  EXPECT_TRUE(asked.hides(4, false, 60));
  EXPECT_FALSE(asked.hides(5, false, 60.1));
}

TEST(AskedTime, givesUpWhatLeadsNowhere) {
  AskedTime asked;
  asked.ask(0);
  EXPECT_FALSE(asked.hides(4, false, 0.1)) << "nothing was heard before";
  asked.ask(10);
  EXPECT_TRUE(asked.hides(4, false, 10 + AskedTime::kPatience / 2));
  EXPECT_FALSE(asked.hides(4, false, 10.1 + AskedTime::kPatience));
  EXPECT_FALSE(asked.hides(4, false, 10.2 + AskedTime::kPatience));
  asked.ask(20);
  asked.end();
  EXPECT_FALSE(asked.hides(4, false, 20)) << "something else was asked for";
}

poinsot::BodyState stateAt(double stamp, double time, unsigned segment = 0) {
  poinsot::BodyState state;
  state.header.stamp = ros::Time(stamp);
  state.time = time;
  state.segment = segment;
  return state;
}

TEST(History, keepsItsWindowOnly) {
  History history(20, 4000);
  for (int i = 0; i <= 60 * 60; ++i) history.add(stateAt(i / 60.0, i / 60.0));
  EXPECT_NEAR(history[0].header.stamp.toSec(), 40, 0.02);
  EXPECT_EQ(history.newest().header.stamp.toSec(), 60);
  EXPECT_NEAR(static_cast<double>(history.size()), 20 * 60, 3);
}

TEST(History, isBoundedHoweverFastTheNode) {
  History history(20, 4000);
  for (int i = 0; i <= 30 * 10000; ++i) history.add(stateAt(i / 10000.0, i / 10000.0));
  EXPECT_LE(history.size(), 4002u);
  EXPECT_GT(history.size(), 3800u);
  EXPECT_EQ(history.newest().header.stamp.toSec(), 30) << "the newest sample is always there";
  for (std::size_t i = 1; i < history.size(); ++i) EXPECT_GT(history[i].header.stamp, history[i - 1].header.stamp);
}

TEST(History, aPauseDoesNotPushItOut) {
  History history(20, 4000);
  for (int i = 0; i <= 300; ++i) history.add(stateAt(i / 60.0, i / 60.0));
  const std::size_t before = history.size();
  for (int i = 1; i <= 6000; ++i) history.add(stateAt(5 + i / 60.0, 5));
  EXPECT_EQ(history.size(), before);
  history.add(stateAt(105 + 1 / 60.0, 5 + 1 / 60.0));
  EXPECT_EQ(history.size(), before + 1);
  EXPECT_EQ(history[0].time, 0);
}

TEST(History, aNewSegmentOrAClockThatGoesBackBeginsAnew) {
  History history(20, 4000);
  for (int i = 0; i < 10; ++i) history.add(stateAt(i, i));
  history.add(stateAt(10, 500, 1));
  ASSERT_EQ(history.size(), 1u);
  EXPECT_EQ(history[0].time, 500);
  history.add(stateAt(11, 501, 1));
  history.add(stateAt(3, 502, 1));
  ASSERT_EQ(history.size(), 1u);
  EXPECT_EQ(history[0].time, 502);
}

TEST(Thinned, keepsThePeaksTheOrderAndTheEnd) {
  QPolygonF points;
  for (int i = 0; i < 4000; ++i) points << QPointF(i, std::sin(0.01 * i));
  points[1777].setY(9);
  points[2222].setY(-9);
  const QPolygonF thin = thinned(points, 250);
  EXPECT_LE(thin.size(), 501);
  double lowest = 0;
  double highest = 0;
  for (int i = 0; i < thin.size(); ++i) {
    lowest = std::min(lowest, thin[i].y());
    highest = std::max(highest, thin[i].y());
    if (i > 0) {
      EXPECT_GE(thin[i].x(), thin[i - 1].x());
    }
  }
  EXPECT_EQ(lowest, -9);
  EXPECT_EQ(highest, 9);
  EXPECT_EQ(thin.back().x(), 3999);
}

TEST(Thinned, leavesAFewAlone) {
  const QPolygonF points(QVector<QPointF>{{0, 1}, {1, 2}, {2, 0}});
  EXPECT_EQ(thinned(points, 250), points);
  EXPECT_TRUE(thinned({}, 250).empty());
}

poinsot::Activity activity(std::uint8_t kind, const std::string& scene, const std::string& body,
                           const std::string& method) {
  poinsot::Activity out;
  out.kind = kind;
  out.scene = scene;
  out.body = body;
  out.method = method;
  return out;
}

TEST(Status, saysWhatIsBeingWorkedOut) {
  using poinsot::Activity;
  poinsot::NodeStatus status;
  EXPECT_EQ(activityText(status), "");
  EXPECT_FALSE(isChanging(status));
  status.activities = {activity(Activity::SEEK, "", "", "")};
  EXPECT_EQ(activityText(status), "seek");
  EXPECT_FALSE(isChanging(status)) << "a seek changes no scene, method or spin";
  status.activities.push_back(activity(Activity::SET_METHOD, "", "wing", "rk4"));
  EXPECT_EQ(activityText(status), "seek and method rk4 of wing");
  EXPECT_TRUE(isChanging(status));
  status.activities = {activity(Activity::SET_SPIN, "", "wing", ""), activity(Activity::SET_SPIN, "", "wing", ""),
                       activity(Activity::RESET, "", "", ""), activity(Activity::LOAD_SCENE, "phone", "", "")};
  EXPECT_EQ(activityText(status), "spin of wing and reset and scene phone") << "each once";
  status.activities = {activity(200, "", "", "")};
  EXPECT_EQ(activityText(status), "a change") << "of a kind that a later version may add";
  EXPECT_TRUE(isChanging(status));
}

TEST(Banner, saysWhatKeepsTheNodeFromBeingControlled) {
  EXPECT_EQ(bannerText(Reach::controllable, "/a"), "");
  EXPECT_TRUE(bannerText(Reach::waits_for_clock, "/a").contains("is waiting for <b>/clock</b>"));
  EXPECT_TRUE(bannerText(Reach::recording, "/a").contains("A recording</b> is shown"));
  EXPECT_TRUE(bannerText(Reach::nobody, "/a").contains("roslaunch poinsot demo.launch"));
  for (const Reach reach : {Reach::waits_for_clock, Reach::recording, Reach::nobody}) {
    EXPECT_TRUE(bannerText(reach, "/<a>").contains("<b>/&lt;a&gt;</b>")) << "the node's name, whatever it is";
  }
}

TEST(MethodWords, agreeWithTheTableOfMethods) {
  std::size_t steppers = 0;
  for (const MethodWords& words : methodWords()) {
    const poinsot::Method* const method = poinsot::findMethod(words.name);
    if (!method) {
      EXPECT_STREQ(words.name, poinsot::kClosedForm);
      EXPECT_TRUE(words.keeps_momentum && words.keeps_energy && words.order == 0);
      continue;
    }
    ++steppers;
    EXPECT_EQ(words.order, method->order) << words.name;
    EXPECT_EQ(words.keeps_momentum, method->conserves_momentum) << words.name;
    EXPECT_EQ(words.keeps_energy, method->conserves_energy) << words.name;
    EXPECT_EQ(words.moves_free, method->make_free != nullptr) << words.name;
  }
  EXPECT_EQ(steppers, poinsot::methods().size());
  EXPECT_EQ(methodWords().size(), steppers + 1) << "the closed form";
}

TEST(MethodWords, sayWhatAMethodIs) {
  EXPECT_EQ(wordsOfMethod("closed_form"), "exact, any t at once, keeps L and E");
  EXPECT_EQ(wordsOfMethod("lie_euler"), "course notes' Algorithm 1, order 1, keeps L, not E");
  EXPECT_EQ(wordsOfMethod("buss2"), "course notes' Algorithm 2, order 2, keeps L, not E");
  EXPECT_EQ(wordsOfMethod("rk4"), "classical Runge–Kutta, order 4, keeps neither L nor E");
  EXPECT_EQ(wordsOfMethod("taylor8"), "Taylor series, order 8, under torques");
  EXPECT_EQ(wordsOfMethod("of_a_later_version"), "");
}

std::string regime(std::uint8_t kind, bool flips, const char* words = "") {
  poinsot::BodyStatus body;
  body.regime_kind = kind;
  body.flips = flips;
  body.regime = words;
  return regimeText(body).toStdString();
}

TEST(RegimeText, saysWhatTheBodyDoes) {
  using Body = poinsot::BodyStatus;
  EXPECT_EQ(regime(Body::ABOUT_LARGEST, true), "turns over; Ω circles the axis of largest moment");
  EXPECT_EQ(regime(Body::ABOUT_LARGEST, false), "wobbles; Ω circles the axis of largest moment");
  EXPECT_EQ(regime(Body::ABOUT_SMALLEST, true), "turns over; Ω circles the axis of smallest moment");
  EXPECT_EQ(regime(Body::ABOUT_SMALLEST, false), "wobbles; Ω circles the axis of smallest moment");
  EXPECT_EQ(regime(Body::CIRCLE, false), "wobbles; Ω circles the axis of symmetry");
  EXPECT_EQ(regime(Body::SEPARATRIX, true), "on the separatrix: turns over once, and never again");
  EXPECT_EQ(regime(Body::BESIDE_SEPARATRIX, true), "on the separatrix, to rounding: turns over seldom");
  EXPECT_EQ(regime(Body::STEADY, false, "steady about the axis of largest moment"),
            "steady spin about the axis of largest moment");
  EXPECT_EQ(regime(Body::UNDER_TORQUE, false, "under torque"), "under torque");
  EXPECT_EQ(regime(200, false, "of a later version"), "of a later version");
}

TEST(Status, doesNotParseText) {
  poinsot::NodeStatus status;
  status.busy = "method rk4 of wing";
  EXPECT_FALSE(isChanging(status));
  EXPECT_EQ(activityText(status), "");
}

TEST(HoldOff, lastsWhileTheNodeIsAtWork) {
  HoldOff hold_off;
  EXPECT_FALSE(hold_off.holds());
  EXPECT_FALSE(hold_off.holds(true)) << "nothing was chosen";
  hold_off.begin();
  EXPECT_TRUE(hold_off.holds());
  hold_off.end();
  EXPECT_FALSE(hold_off.holds());
}

rviz::Config parsed(const char* text) {
  rviz::Config config;
  rviz::YamlConfigReader().readString(config, text);
  return config;
}

poinsot::SceneLayout layoutOfTwo() {
  poinsot::SceneLayout out;
  out.picture_radius = 0.5;
  out.pitch = 0.2;
  for (const double y : {-1.0, 3.0}) {
    out.centres.emplace_back();
    out.centres.back().y = y;
    out.radii.push_back(0.5);
  }
  out.bodies = out.frames = out.pictures = {"wing", "wing2"};
  return out;
}

TEST(SceneViews, aLayoutThatCannotBeShownIsNoticed) {
  EXPECT_TRUE(scene_views::isUsable(layoutOfTwo()));
  for (const double bad : {kNaN, kInfinity, -1.0}) {
    poinsot::SceneLayout layout = layoutOfTwo();
    layout.radii[1] = bad;
    EXPECT_FALSE(scene_views::isUsable(layout)) << bad;
    layout = layoutOfTwo();
    layout.picture_radius = bad;
    EXPECT_FALSE(scene_views::isUsable(layout)) << bad;
  }
  poinsot::SceneLayout layout = layoutOfTwo();
  layout.centres[0].z = kNaN;
  EXPECT_FALSE(scene_views::isUsable(layout));
  layout = layoutOfTwo();
  layout.radii.pop_back();
  EXPECT_FALSE(scene_views::isUsable(layout));
  layout = layoutOfTwo();
  layout.frames.clear();
  EXPECT_FALSE(scene_views::isUsable(layout));
  layout = layoutOfTwo();
  layout.pitch = 2;
  EXPECT_FALSE(scene_views::isUsable(layout));
}

TEST(SceneViews, theOverviewShowsTheLayout) {
  const rviz::Config view = scene_views::overviewOf(layoutOfTwo(), 1.6);
  float y = 0, distance = 0, wide = 0;
  EXPECT_TRUE(view.mapGetChild("Focal Point").mapGetFloat("Y", &y));
  EXPECT_NEAR(y, 1, 0.01) << "the middle";
  EXPECT_TRUE(view.mapGetFloat("Distance", &distance));
  EXPECT_TRUE(scene_views::overviewOf(layoutOfTwo(), 3.2).mapGetFloat("Distance", &wide));
  EXPECT_LT(wide, distance) << "a wide window shows it from nearer";
}

TEST(SceneViews, ridingIsOnTheBodysPicture) {
  QString frame;
  EXPECT_TRUE(scene_views::ridingOf(layoutOfTwo(), "robot/wing").mapGetString("Target Frame", &frame));
  EXPECT_EQ(frame, "robot/wing_space_body");
  float distance = 0;
  EXPECT_TRUE(scene_views::alongOf(layoutOfTwo(), "wing").mapGetFloat("Distance", &distance));
  EXPECT_NEAR(distance, 2.1, 1e-6) << "grows with the picture";
}

TEST(SceneViews, ridingLeavesOutAllButThePictureInWorldAxes) {
  const rviz::Config hidden = scene_views::hiddenFor(layoutOfTwo(), "wing").mapGetChild("Riding");
  std::set<std::string> names;
  for (const char* display : {"Still", "Motion"}) {
    const rviz::Config list = hidden.mapGetChild(display);
    for (int i = 0; i < list.listLength(); ++i) names.insert(list.listChildAt(i).getValue().toString().toStdString());
  }
  EXPECT_EQ(names.count("wing/space/omega"), 0);
  for (const char* other :
       {"wing/shape", "wing/model/omega", "wing2/space/omega", "wing2/label", "wing/label", "wing/orbit", "/line"}) {
    EXPECT_EQ(names.count(other), 1) << other;
  }
  EXPECT_TRUE(hidden.mapGetChild("Floor").isValid());
  EXPECT_FALSE(scene_views::hiddenFor(layoutOfTwo(), "wing").mapGetChild("Along L").mapGetChild("Floor").isValid());
}

TEST(HiddenParts, comesBackAsItWasSaved) {
  const rviz::Config panel = parsed("{Hidden: {Riding: {Floor: true}}, Switched Off: [Still/label, Floor]}");
  HiddenParts hidden;
  hidden.load(panel);
  rviz::Config saved;
  hidden.save(saved, "Riding");
  EXPECT_TRUE(saved.mapGetChild("Hidden").mapGetChild("Riding").mapGetChild("Floor").isValid());
  const rviz::Config off = saved.mapGetChild("Switched Off");
  ASSERT_EQ(off.listLength(), 2);
  EXPECT_EQ(off.listChildAt(0).getValue().toString(), "Floor");
  EXPECT_EQ(off.listChildAt(1).getValue().toString(), "Still/label");
  rviz::Config elsewhere;
  hidden.save(elsewhere, "Overview");
  EXPECT_FALSE(elsewhere.mapGetChild("Switched Off").isValid()) << "a view that leaves nothing out";
}

TEST(MomentumCamera, standsAtTheTipOfL) {
  for (const Eigen::Vector3d& l :
       {Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(-4, 1, -2), Eigen::Vector3d(0, -1e-200, 0)}) {
    const OrbitAngles angles = anglesAlong(l);
    const Eigen::Vector3d eye(std::cos(angles.pitch) * std::cos(angles.yaw),
                              std::cos(angles.pitch) * std::sin(angles.yaw), std::sin(angles.pitch));
    EXPECT_LT((eye - l.stableNormalized()).norm(), 1e-12) << l.transpose();
  }
  for (const double z : {1.0, -1.0}) {
    const OrbitAngles angles = anglesAlong({0.05, -0.05, z});
    EXPECT_EQ(angles.yaw, 0) << "not turned round where L is nearly upright";
    EXPECT_DOUBLE_EQ(angles.pitch, z * M_PI / 2);
  }
}

TEST(MomentumCamera, followsAMotionThatBeginsAnew) {
  poinsot::BodyState before, now;
  before.body = now.body = "wing";
  before.segment = 3;
  before.time = now.time = 5;
  before.momentum_world.x = now.momentum_world.y = 1;
  now.segment = 3;
  EXPECT_FALSE(beginsAlongAnotherMomentum(before, now)) << "the same segment";
  now.segment = 4;
  EXPECT_TRUE(beginsAlongAnotherMomentum(before, now));
  now.attitude_error = kNaN;
  EXPECT_FALSE(beginsAlongAnotherMomentum(before, now)) << "a seek under torques";
  now.time = 0.1;
  EXPECT_TRUE(beginsAlongAnotherMomentum(before, now)) << "a new start under torques";
  now.momentum_world = before.momentum_world;
  EXPECT_FALSE(beginsAlongAnotherMomentum(before, now)) << "the same L";
  now.body = "book";
  EXPECT_TRUE(beginsAlongAnotherMomentum(before, now)) << "another body";
}

TEST(Text, figures) {
  EXPECT_EQ(text::seconds(12.345), "12.35 s");
  EXPECT_EQ(text::seconds(-0.001), "0.00 s");
  EXPECT_EQ(text::seconds(-12), "−12.00 s");
  EXPECT_EQ(text::seconds(1e9 + 0.25), "1000000000.25 s");
  EXPECT_EQ(text::seconds(kInfinity), "∞ s");
  EXPECT_EQ(text::seconds(kNaN), "–");
  EXPECT_EQ(text::withPrefix(4532.19, "J"), "4.53 kJ");
  EXPECT_EQ(text::withPrefix(1.3e-6, "s"), "1.3 µs");
  EXPECT_EQ(text::withPrefix(999.9, "J"), "1000 J");
  EXPECT_EQ(text::withPrefix(0, "J"), "0 J");
  EXPECT_EQ(text::withPrefix(1e-12, "J"), "1 pJ");
  EXPECT_EQ(text::withPrefix(-2, "J"), "−2 J");
  EXPECT_EQ(text::withPrefix(kNaN, "J"), "–");
  EXPECT_EQ(text::small(1.23e-16), "1.2e−16");
  EXPECT_EQ(text::small(-1.23e-7), "−1.2e−7");
  EXPECT_EQ(text::small(0.01234), "0.0123");
  EXPECT_EQ(text::small(1e9), "1.0e9");
  EXPECT_EQ(text::small(0), "0");
  EXPECT_EQ(text::speed(-0.5), "×−0.5");
}

TEST(Text, whatIsTyped) {
  bool ok = false;
  EXPECT_EQ(text::number(" 12.5 ", &ok), 12.5);
  EXPECT_TRUE(ok);
  EXPECT_EQ(text::number("−3,5", &ok), -3.5);
  EXPECT_TRUE(ok);
  EXPECT_EQ(text::number("1e9", &ok), 1e9);
  EXPECT_TRUE(ok);
  for (const char* bad : {"", "abc", "1 2", "1.2.3"}) {
    text::number(bad, &ok);
    EXPECT_FALSE(ok) << bad;
  }
}

TEST(Worker, doesJobsInTheirOrderAndGivesAnswersWhenAsked) {
  std::vector<int> read;
  std::atomic<int> done{0};
  Worker worker;
  for (int i = 0; i < 5; ++i) {
    worker.post([&, i] {
      ++done;
      return [&read, i] { read.push_back(i); };
    });
  }
  worker.post([&]() -> Worker::Answer {
    ++done;
    return nullptr;
  });
  while (done < 6) std::this_thread::yield();
  EXPECT_TRUE(read.empty()) << "answers wait until they are read";
  while (read.size() < 5) worker.read();
  EXPECT_EQ(read, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(Worker, dropsWhatIsNoLongerWanted) {
  std::atomic<bool> began{false}, release{false}, ended{false}, second{false};
  bool answered = false;
  {
    Worker worker;
    worker.post([&] {
      began = true;
      while (!release) std::this_thread::yield();
      return [&answered] { answered = true; };
    });
    worker.post([&]() -> Worker::Answer {
      second = true;
      return nullptr;
    });
    while (!began) std::this_thread::yield();
    worker.drop();
    worker.post([&]() -> Worker::Answer {
      ended = true;
      return nullptr;
    });
    release = true;
    while (!ended) std::this_thread::yield();
    worker.read();
  }
  EXPECT_FALSE(second) << "a job that had not begun";
  EXPECT_FALSE(answered) << "the answer of one that had";
}

TEST(Worker, isLeftBehindWhenItHangs) {
  const auto release = std::make_shared<std::atomic<bool>>(false);
  const auto began = std::make_shared<std::atomic<bool>>(false);
  {
    Worker worker;
    worker.post([=] {
      *began = true;
      while (!*release) std::this_thread::yield();
      return nullptr;
    });
    while (!*began) std::this_thread::yield();
  }  // comes back although the job has not
  EXPECT_FALSE(*release);
  *release = true;
}

}  // namespace
