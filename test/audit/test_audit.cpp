#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <sstream>

#include "stream.h"

namespace poinsot::test {
namespace {

using audit::Options;
using audit::Report;
using Eigen::Quaterniond;
using Eigen::Vector3d;

const Quaterniond kTilted = Quaterniond(1, 2, 3, 4).normalized();
const Vector3d kOmega(0.6, 1.1, -2.3);

Stream asymmetric(const std::vector<Tick>& ticks = steadily(150), BodySetup setup = {}) {
  return {setup, anyBody(setup.tensor(), kTilted, kOmega), ticks};
}

std::string print(const Report& report) {
  std::ostringstream out;
  out << report;
  return out.str();
}

void expectPass(const Report& report) {
  EXPECT_TRUE(report.passed()) << print(report);
}

/** Expects that exactly these checks fail, one of them with a detail that matches `words`, a regular expression. */
void expectFailures(const Report& report, const std::set<std::string>& names, const std::string& words) {
  std::set<std::string> failed;
  bool said = false;
  for (const audit::Check& check : report.failures()) {
    failed.insert(check.name);
    said = said || std::regex_search(check.detail, std::regex(words));
  }
  EXPECT_EQ(failed, names) << print(report);
  EXPECT_TRUE(said) << "nobody says \"" << words << "\"\n" << print(report);
}

const char* const kRotation = "dR/dstamp = time_rate R hat(omega)";
const char* const kTime = "time advances by time_rate";
const char* const kDriftFields = "energy_drift and momentum_drift";

// Streams that must pass.

TEST(Correct, AsymmetricBody) {
  const Report report = asymmetric().judged();
  expectPass(report);
  EXPECT_EQ(report.find("E conserved")->count, 150);
  EXPECT_EQ(report.find("tf = state")->count, 300);
  EXPECT_EQ(report.find(kRotation)->count, 149);
  EXPECT_EQ(report.find("omega on both ellipsoids (space)")->count, 300);
  EXPECT_EQ(report.find("omega on both ellipsoids (model)")->count, 300);
  EXPECT_EQ(report.find("polhode on both ellipsoids (model)")->count, 2);
}

TEST(Correct, AxesThatAreNotPrincipal) {
  BodySetup setup;
  setup.axes = Quaterniond(0.3, -0.4, 0.7, 0.1).normalized();
  expectPass(asymmetric(steadily(100), setup).judged());
}

TEST(Correct, SymmetricTopToRoundoff) {
  BodySetup setup;
  setup.moments = {2, 2, 3};
  setup.method = "closed_form";
  const Report report = Stream(setup, symmetricTop(2, 3, kTilted, kOmega), steadily(300)).judged();
  expectPass(report);
  EXPECT_LT(report.find("E conserved")->bound, 1e-12);
  EXPECT_LT(report.find(kRotation)->bound, 1e-7);
}

TEST(Correct, ClosedFormFarFromTheStart) {
  BodySetup setup;
  setup.moments = {2, 2, 3};
  setup.method = "closed_form";
  expectPass(Stream(setup, symmetricTop(2, 3, kTilted, kOmega), steadily(60, 1000)).judged());
}

TEST(Correct, FastSpin) {
  BodySetup setup;
  setup.moments = {2, 2, 3};
  setup.method = "closed_form";
  expectPass(Stream(setup, symmetricTop(2, 3, kTilted, {10, 20, 100}), steadily(60)).judged());
}

TEST(Correct, AtRest) {
  BodySetup setup;
  setup.method = "closed_form";
  expectPass(Stream(setup, anyBody(setup.tensor(), kTilted, Vector3d::Zero()), steadily(30)).judged());
}

/** The body alone: without the markers of its pictures, and with a layout that has pictures of these bodies. */
Report judgedAlone(Stream stream, const std::vector<std::string>& pictures, bool keeps_one = false) {
  for (visualization_msgs::MarkerArray& markers : stream.markers) markers.markers.clear();
  std::vector<visualization_msgs::Marker>& still = stream.markers_static.markers;
  const visualization_msgs::Marker one = still.front();
  still.clear();
  if (keeps_one) still.push_back(one);
  visualization_msgs::Marker shape;
  shape.ns = stream.setup.body + "/shape";
  shape.header.frame_id = stream.setup.body;
  still.push_back(shape);
  audit::Audit audit;
  SceneLayout layout;
  layout.pictures = pictures;
  audit.add(layout);
  stream.feed(audit);
  return audit.report();
}

TEST(Correct, ABodyWithoutPictures) {
  expectPass(judgedAlone(asymmetric(steadily(60)), {"another"}));
}

TEST(Wrong, PicturesThatTheLayoutHasNot) {
  expectFailures(judgedAlone(asymmetric(steadily(60)), {"another"}, true), {"no pictures"}, "has no pictures");
  EXPECT_FALSE(judgedAlone(asymmetric(steadily(60)), {"wingnut"}).passed()) << "pictures that it promises are missed";
}

TEST(Correct, Translation) {
  BodySetup setup;
  setup.effects = {"translation: position [0, 0, 0], velocity [1, -2, 5], acceleration [0, 0, -9.81]"};
  setup.velocity = {1, -2, 5};
  setup.acceleration = {0, 0, -9.81};
  expectPass(asymmetric(steadily(100), setup).judged());
}

TEST(Correct, TwoNodesWithPrefixes) {
  BodySetup a, b;
  a.ns = "/a";
  a.prefix = "a/";
  b.ns = "/b";
  b.prefix = "b/";
  b.moments = {1, 1.5, 2};
  audit::Audit audit, bare(Options{1e-3, true, false, true, 2, 0});
  Stream first = asymmetric(steadily(60), a), second = asymmetric(steadily(60), b);
  first.feed(audit);
  second.feed(audit);
  expectPass(audit.report());
  EXPECT_NE(audit.report().find("tf = state", "/a/wingnut"), nullptr);
  EXPECT_NE(audit.report().find("tf = state", "/b/wingnut"), nullptr);
  // Without odometry to name the frames, each body finds the one that turns as it does.
  first.odometry.clear();
  second.odometry.clear();
  first.feed(bare);
  second.feed(bare);
  expectPass(bare.report());
}

TEST(Correct, CostsThatAreNotMeasured) {
  Stream stream = asymmetric();
  for (BodyState& state : stream.states) state.cost = std::nan("");
  expectPass(stream.judged());
  stream.states[7].cost = HUGE_VAL;
  expectFailures(stream.judged(), {"finite numbers"}, "state: cost is not finite");
}

/** Every command takes effect at a message: rates change there, a pause holds, a step runs for 1/60 s. */
TEST(Correct, SpeedPauseStepBackwards) {
  std::vector<Tick> ticks = steadily(200);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    ticks[i].time_rate = i < 40 ? 1 : i < 80 ? 2.5 : i < 110 ? 0 : i == 110 ? 1 : i < 140 ? 0 : -2;
    if (i > 0) {
      ticks[i].time =
          ticks[i - 1].time + ticks[i - 1].time_rate * 1e-9 * static_cast<double>(ticks[i].stamp - ticks[i - 1].stamp);
    }
  }
  expectPass(asymmetric(ticks).judged());
}

TEST(Correct, SeekInANewSegment) {
  std::vector<Tick> ticks = steadily(100);
  for (std::size_t i = 50; i < ticks.size(); ++i) {
    ticks[i].time -= 0.7;
    ticks[i].segment = 1;
  }
  expectPass(asymmetric(ticks).judged());
}

/** A clock that runs 1 s and jumps back, several times: stamps overlap, by `shift` [ns] apart; t goes on. */
Stream clockLoops(int loops, std::int64_t shift, bool counted) {
  std::vector<Tick> ticks;
  for (int loop = 0; loop < loops; ++loop) {
    for (Tick tick : steadily(61)) {
      tick.stamp += shift * (loops - loop);
      tick.time += loop;
      tick.segment = static_cast<std::uint32_t>(7 + loop);
      ticks.push_back(tick);
    }
  }
  Stream stream = asymmetric(ticks);
  for (std::size_t i = 0; counted && i < stream.states.size(); ++i) {
    stream.states[i].header.seq = static_cast<std::uint32_t>(100 + i);
  }
  return stream;
}

/** As a bag lists it that was recorded by the clock of its stamps. */
Stream listedByStamp(Stream stream) {
  const auto byHeader = [](const auto& a, const auto& b) { return a.header.stamp < b.header.stamp; };
  std::stable_sort(stream.states.begin(), stream.states.end(), byHeader);
  std::stable_sort(stream.odometry.begin(), stream.odometry.end(), byHeader);
  std::stable_sort(stream.tf.begin(), stream.tf.end(),
                   [&](const auto& a, const auto& b) { return byHeader(a.transforms[0], b.transforms[0]); });
  std::stable_sort(stream.markers.begin(), stream.markers.end(),
                   [&](const auto& a, const auto& b) { return byHeader(a.markers[0], b.markers[0]); });
  return stream;
}

TEST(Correct, AClockThatJumpsBackSeveralTimes) {
  for (const bool counted : {true, false}) {
    for (const std::int64_t shift : {0, 3000000, -3000000}) {
      SCOPED_TRACE(std::to_string(shift) + (counted ? " ns, counted" : " ns"));
      const Stream stream = clockLoops(4, shift, counted);
      expectPass(stream.judged());
      const Report report = listedByStamp(stream).judged();
      expectPass(report);
      EXPECT_EQ(report.find(kRotation)->count, 4 * 60);
      EXPECT_EQ(report.find("tf = state")->count, 2 * 4 * 61);
    }
  }
}

/** Messages reach a recorder late or not at all, those of one topic before those of another. */
TEST(Correct, AClockThatJumpsBackAsItIsRecorded) {
  Stream stream = clockLoops(3, 0, true);
  stream.states.erase(stream.states.begin(), stream.states.begin() + 3);
  stream = listedByStamp(stream);
  std::swap(stream.odometry[70], stream.odometry[75]);
  std::swap(stream.tf[50], stream.tf[58]);
  std::swap(stream.states[80], stream.states[85]);
  expectPass(stream.judged());
  stream.markers[100].markers[1].pose.position.x += 1e-6;
  expectFailures(stream.judged(), {"omega drawn to scale (model)", "omega on both ellipsoids (model)"},
                 "model/omega is drawn at");
}

/** A bag that is played in a loop sends the same messages again; a recording of that may begin at any time. */
TEST(Correct, ARecordingPlayedInALoop) {
  const Stream once = clockLoops(2, 3000000, true);
  for (const std::size_t joined : {0, 80}) {
    Stream looped = once;
    const auto again = [joined](auto& messages) {
      const auto played = messages;
      messages.erase(messages.begin(), messages.begin() + static_cast<std::ptrdiff_t>(joined));
      for (int i = 0; i < 2; ++i) messages.insert(messages.end(), played.begin(), played.end());
    };
    again(looped.states);
    again(looped.odometry);
    again(looped.tf);
    again(looped.markers);
    for (const Stream& stream : {looped, listedByStamp(looped)}) {
      const Report report = stream.judged();
      expectPass(report);
      EXPECT_EQ(report.find(kRotation)->count, 2 * 60);
    }
  }
}

TEST(Correct, RecordingThatBeginsInMidSegmentAndTopicsThatBeginAtDifferentTimes) {
  BodySetup setup;
  setup.moments = {1, 2, 3};
  setup.method = "lie_euler";
  setup.step = 1e-5;
  Stream stream(setup, lieEuler(setup.moments, kTilted, kOmega, setup.step), steadily(60));
  stream.states.erase(stream.states.begin(), stream.states.begin() + 20);
  stream.tf.erase(stream.tf.begin(), stream.tf.begin() + 25);
  stream.odometry.resize(stream.odometry.size() - 5);
  const Report report = stream.judged();
  expectPass(report);
  EXPECT_EQ(report.find("tf = state")->count, 2 * 35);
  stream.states[7].energy_drift += 1e-9;
  expectFailures(stream.judged(), {kDriftFields}, "energy_drift says");
}

TEST(Correct, LieEulerAtAFineStep) {
  BodySetup setup;
  setup.method = "lie_euler";
  setup.step = 1e-5;
  expectPass(Stream(setup, lieEuler(setup.moments, kTilted, kOmega, setup.step), steadily(60)).judged());
}

// Streams that must fail, and how.

TEST(Wrong, EnergyWithoutItsHalf) {
  Stream stream = asymmetric();
  for (auto& state : stream.states) state.kinetic_energy *= 2;
  expectFailures(stream.judged(), {"kinetic_energy = 1/2 omega' M omega"}, "kinetic_energy is 2\\.000 times ½ΩᵀMΩ");
}

TEST(Wrong, MomentumEllipsoidWithTheRoot) {
  Stream stream = asymmetric();
  auto& scale = stream.drawn("model/momentum_ellipsoid").scale;
  const double l = 0.5 * scale.x / stream.setup.scale * 1;
  scale.x = 2 * stream.setup.scale * l / std::sqrt(1);
  scale.y = 2 * stream.setup.scale * l / std::sqrt(2);
  scale.z = 2 * stream.setup.scale * l / std::sqrt(3);
  expectFailures(
      stream.judged(),
      {"momentum ellipsoid (model)", "omega on both ellipsoids (model)", "polhode on both ellipsoids (model)"},
      "momentum ellipsoid's semi-axes are .*expected \\|L\\|/mu = .*they are sqrt\\(F/mu\\)");
}

TEST(Wrong, EnergyEllipsoidWithoutTheTwo) {
  Stream stream = asymmetric();
  auto& scale = stream.drawn("space/energy_ellipsoid").scale;
  for (double* axis : {&scale.x, &scale.y, &scale.z}) *axis /= std::sqrt(2);
  expectFailures(stream.judged(),
                 {"energy ellipsoid (space)", "omega on both ellipsoids (space)", "polhode on both ellipsoids (space)"},
                 "they are sqrt\\(E/mu\\)");
}

TEST(Wrong, ScaleAsRadius) {
  Stream stream = asymmetric();
  auto& scale = stream.drawn("model/energy_ellipsoid").scale;
  for (double* axis : {&scale.x, &scale.y, &scale.z}) *axis /= 2;
  expectFailures(stream.judged(),
                 {"energy ellipsoid (model)", "omega on both ellipsoids (model)", "polhode on both ellipsoids (model)"},
                 "given as a radius");
}

TEST(Wrong, RotationTransposedInTf) {
  Stream stream = asymmetric();
  for (auto& message : stream.tf) {
    auto& q = message.transforms[0].transform.rotation;
    q.w = -q.w;
  }
  expectFailures(stream.judged(), {"tf = state"}, "tf's rotation is the inverse of the state's");
}

TEST(Wrong, TfOfThePictureTurnedAlone) {
  Stream stream = asymmetric();
  for (auto& message : stream.tf) {
    auto& q = message.transforms[1].transform.rotation;
    q.w = -q.w;
  }
  expectFailures(stream.judged(), {"tf of space_body = state", "omega on both ellipsoids (space)"}, "inverse");
}

TEST(Wrong, OdometryInWorldAxes) {
  Stream stream = asymmetric();
  for (std::size_t i = 0; i < stream.states.size(); ++i) {
    stream.odometry[i].twist.twist.angular = stream.states[i].omega_world;
  }
  expectFailures(stream.judged(), {"odometry twist in body axes"},
                 "odometry twist.angular is not omega_body \\(it looks like omega_world\\)");
}

TEST(Wrong, OmegaOfTheStateInWorldAxes) {
  Stream stream = asymmetric();
  for (auto& state : stream.states) state.omega_body = state.omega_world;
  EXPECT_TRUE(std::regex_search(stream.judged().find(kRotation)->detail,
                                std::regex("omega_body looks like the angular velocity in world axes")))
      << print(stream.judged());
}

TEST(Wrong, TfLater) {
  Stream stream = asymmetric();
  for (auto& message : stream.tf) message.transforms[0].header.stamp += ros::Duration(0.01);
  expectFailures(stream.judged(), {"tf = state"}, "no tf at the stamp of a state; the nearest is 6\\.7 ms earlier");
  stream = asymmetric();
  for (auto& message : stream.tf) message.transforms[0].header.stamp += ros::Duration(0.001);
  expectFailures(stream.judged(), {"tf = state"}, "no tf at the stamp of a state; the nearest is 1\\.0 ms later");
}

TEST(Wrong, OneTfMissing) {
  Stream stream = asymmetric();
  stream.tf.erase(stream.tf.begin() + 70);
  expectFailures(stream.judged(), {"tf = state", "tf of space_body = state", "omega on both ellipsoids (space)"},
                 "missing for 1 of 150");
  Options live;
  live.losses = 0.01;
  expectPass(stream.judged(live));
}

/** The whole motion slowly turns about z: nothing but L sees it, where it is slow against the rounding of stamps. */
TEST(Wrong, MomentumTurnsSlowly) {
  BodySetup setup;
  setup.moments = {2, 2, 3};
  setup.method = "closed_form";
  const Truth top = symmetricTop(2, 3, kTilted, kOmega);
  const Truth turning = [top](double t) {
    const Moment m = top(t);
    return Moment{Quaterniond(Eigen::AngleAxisd(1e-8 * t, Vector3d::UnitZ())) * m.attitude, m.omega_body};
  };
  expectFailures(Stream(setup, turning, steadily(150)).judged(), {"L conserved"},
                 "L turns \\(in rad\\) by .*closed_form");
}

TEST(Wrong, TimeRateOffByOnePercent) {
  Stream stream = asymmetric();
  for (auto& state : stream.states) state.time_rate = 1.01;
  expectFailures(stream.judged(), {kTime, kRotation}, "R turns 0\\.990. times as far");
  expectFailures(stream.judged(), {kTime, kRotation}, "ratio 0\\.9901");
}

TEST(Wrong, TimeRateAndTimeBothOffByOnePercent) {
  Stream stream = asymmetric();
  for (auto& state : stream.states) {
    state.time_rate = 1.01;
    state.time *= 1.01;
  }
  expectFailures(stream.judged(), {kRotation, "Euler's equations"}, "R turns 0\\.990. times as far");
}

TEST(Wrong, QuaternionNotUnit) {
  Stream stream = asymmetric();
  stream.states[30].attitude.w *= 1 + 1e-9;
  stream.states[30].attitude.x *= 1 + 1e-9;
  stream.states[30].attitude.y *= 1 + 1e-9;
  stream.states[30].attitude.z *= 1 + 1e-9;
  expectFailures(stream.judged(), {"unit quaternions"}, "state: expected a unit quaternion, got the norm 1\\.00000000");
}

TEST(Wrong, NotFinite) {
  Stream stream = asymmetric();
  stream.states[30].omega_world.y = NAN;
  expectFailures(stream.judged(), {"finite numbers"}, "state: omega_world is not finite");
  stream = asymmetric();
  stream.markers[30].markers[0].points[1].x = INFINITY;
  expectFailures(stream.judged(), {"markers well formed"}, "wingnut/space/omega: a point is not finite");
}

TEST(Wrong, MissingTopics) {
  Stream stream = asymmetric(steadily(60));
  Stream bare = stream;
  bare.odometry.clear();
  expectFailures(bare.judged(), {"odometry = state"}, "no odometry was received");
  Options options;
  options.odometry = false;
  expectPass(bare.judged(options));

  bare = stream;
  bare.tf.clear();
  expectFailures(bare.judged(), {"tf = state", "omega on both ellipsoids (space)"}, "no tf was received");
  options = {};
  options.tf = false;
  expectPass(bare.judged(options));

  bare = stream;
  bare.markers.clear();
  bare.markers_static.markers.clear();
  EXPECT_EQ(bare.judged().find("markers well formed")->detail, "no marker of this body was received");
  EXPECT_FALSE(bare.judged().passed());
  options = {};
  options.markers = false;
  expectPass(bare.judged(options));

  bare = stream;
  bare.description = {};
  expectFailures(bare.judged(), {"description"}, "no description was received");

  bare = stream;
  bare.states.clear();
  expectFailures(bare.judged(), {"states"}, "no state of this body");

  EXPECT_FALSE(audit::Audit().report().passed());
}

TEST(Wrong, SegmentGoesBackwards) {
  std::vector<Tick> ticks = steadily(60);
  for (std::size_t i = 0; i < ticks.size(); ++i) ticks[i].segment = i < 30 ? 5 : 4;
  expectFailures(asymmetric(ticks).judged(), {"segments never decrease"}, "segment 4 comes after segment 5");
}

/** Where the clock jumps back, too, only the order in which a node sends is forgiven. */
TEST(Wrong, AClockThatJumpsBackAndOneMessageThatIsWrong) {
  for (const bool by_stamp : {false, true}) {
    SCOPED_TRACE(by_stamp);
    Stream stream = clockLoops(3, 3000000, true);
    stream.states[80].energy_drift += 1e-9;
    stream.states[100].time_rate = 1.01;
    if (by_stamp) stream = listedByStamp(stream);
    expectFailures(stream.judged(), {kTime, kRotation, kDriftFields}, "R turns 0\\.990. times as far");
  }
  Stream stream = clockLoops(3, 3000000, true);
  std::swap(stream.tf[70], stream.tf[71]);
  expectFailures(stream.judged(), {"stamps never decrease"},
                 "tf of wingnut: 3 stamps lie before the previous one, and the clock jumped back 2 times");
  stream = clockLoops(1, 0, true);
  for (std::size_t i = 0; i < stream.states.size(); ++i) stream.states[i].segment = i % 2;
  EXPECT_FALSE(stream.judged().find("segments never decrease")->passed);
}

TEST(Wrong, StampsDecrease) {
  Stream stream = asymmetric(steadily(60));
  std::swap(stream.states[20], stream.states[21]);
  const Report report = stream.judged();
  EXPECT_FALSE(report.find("stamps never decrease")->passed);
  EXPECT_TRUE(std::regex_search(report.find("stamps never decrease")->detail, std::regex("0\\.01666[67] s before")));
}

TEST(Wrong, EnergyDriftsMoreThanTheMethodAllows) {
  BodySetup setup;
  setup.moments = {2, 2, 3};
  setup.method = "closed_form";
  const Truth top = symmetricTop(2, 3, kTilted, kOmega);
  const Truth faster = [top](double t) {
    const Moment m = top(t);
    return Moment{m.attitude, (1 + 1e-10 * t) * m.omega_body};
  };
  const Report report = Stream(setup, faster, steadily(150)).judged();
  EXPECT_FALSE(report.find("E conserved")->passed) << print(report);
  EXPECT_FALSE(report.find("|L| conserved")->passed) << print(report);
}

/** Lie-Euler keeps to its own bound, but not to the ceiling for ground truth. */
TEST(Wrong, LieEulerAtACoarseStep) {
  BodySetup setup;
  setup.method = "lie_euler";
  setup.step = 0.01;
  const Stream stream(setup, lieEuler(setup.moments, kTilted, kOmega, setup.step), steadily(120));
  expectFailures(stream.judged(), {"E conserved"},
                 "energy drifts by .*: method lie_euler at step 0\\.01 s is too coarse for ground truth");
}

TEST(Wrong, DriftField) {
  Stream stream = asymmetric(steadily(60));
  stream.states[40].momentum_drift = 1e-6;
  expectFailures(stream.judged(), {kDriftFields}, "momentum_drift says 1e-06");
}

TEST(Correct, AttitudeErrorOfAStepper) {
  Stream stream = asymmetric(steadily(60));
  for (auto& state : stream.states) state.attitude_error = NAN;  // the node may have nothing to compare with
  expectPass(stream.judged());
  BodySetup setup;
  setup.method = "lie_euler";
  setup.step = 1e-5;
  const Truth exact = anyBody(setup.tensor(), kTilted, kOmega);
  Stream stepped(setup, lieEuler(setup.moments, kTilted, kOmega, setup.step), steadily(120));
  for (auto& state : stepped.states) {
    state.attitude_error = audit::angleBetween(audit::quaternionOf(state.attitude), exact(state.time).attitude);
  }
  EXPECT_GT(stepped.states.back().attitude_error, 1e-6);
  expectPass(stepped.judged());
  EXPECT_EQ(stepped.judged().find("attitude_error")->count, 120);
}

TEST(Wrong, AttitudeError) {
  const auto spoilt = [](const char* method, double error) {
    BodySetup setup;
    setup.moments = {2, 2, 3};
    setup.method = method;
    Stream stream(setup, symmetricTop(2, 3, kTilted, kOmega), steadily(60));
    stream.states[20].attitude_error = error;
    return stream.judged();
  };
  expectPass(spoilt("closed_form", 0));
  expectPass(spoilt("rk4", 1e-13));
  expectFailures(spoilt("closed_form", 1e-14), {"attitude_error"},
                 "says 1e-14 rad at t = 0\\.333333 s, more than method");
  expectFailures(spoilt("closed_form", NAN), {"attitude_error"}, "NaN under the closed form itself");
  expectFailures(spoilt("rk4", 1e-6), {"attitude_error"}, "more than method rk4 allows");
  expectFailures(spoilt("rk4", -1e-15), {"attitude_error"}, "attitude_error: expected at least 0, got -1e-15 rad");
  expectFailures(spoilt("rk4", INFINITY), {"attitude_error"}, "says inf rad");
  expectFailures(spoilt("unheard_of", 3.2), {"attitude_error"}, "more than method unheard_of allows \\(3\\.14\\)");
}

TEST(Wrong, PointOfTheModelShifted) {
  Stream stream = asymmetric(steadily(60));
  for (auto& message : stream.markers) message.markers[1].pose.position.x += 1e-6;
  expectFailures(stream.judged(), {"omega drawn to scale (model)", "omega on both ellipsoids (model)"},
                 "model/omega is drawn at");
}

TEST(Wrong, MarkersWithOtherStamps) {
  Stream stream = asymmetric(steadily(60));
  for (auto& message : stream.markers) {
    for (auto& marker : message.markers) marker.header.stamp += ros::Duration(0.002);
  }
  const Report report = stream.judged();
  EXPECT_TRUE(std::regex_search(report.find("marker stamps are states' stamps")->detail, std::regex("2\\.0 ms off")))
      << print(report);
}

TEST(Wrong, PausedButMoving) {
  std::vector<Tick> ticks = steadily(60);
  Stream stream = asymmetric(ticks);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    stream.states[i].time_rate = 0;
    stream.states[i].time = 0;
  }
  expectFailures(stream.judged(), {kRotation, "Euler's equations"}, "time stands still .* but R turns by");
}

TEST(Wrong, SeekWithoutANewSegment) {
  std::vector<Tick> ticks = steadily(100);
  for (std::size_t i = 50; i < ticks.size(); ++i) ticks[i].time += 0.7;
  expectFailures(asymmetric(ticks).judged(), {kTime, kRotation}, "time advances by 0\\.716");
}

TEST(Wrong, PrincipalAxesInverted) {
  BodySetup setup;
  setup.axes = Quaterniond(0.3, -0.4, 0.7, 0.1).normalized();
  Stream stream = asymmetric(steadily(30), setup);
  stream.description.principal_axes.w *= -1;
  expectFailures(stream.judged(), {"description"}, "looks like the inverse rotation");
}

TEST(Wrong, PositionLeavesTheParabola) {
  BodySetup setup;
  setup.effects = {"translation: position [0, 0, 0], velocity [1, -2, 5], acceleration [0, 0, -9.81]"};
  setup.velocity = {1, -2, 5};
  setup.acceleration = {0, 0, -9.81};
  Stream stream = asymmetric(steadily(60), setup);
  for (std::size_t i = 0; i < 60; ++i) {
    stream.states[i].position.z += 1e-6 * std::pow(stream.states[i].time, 3);
    stream.tf[i].transforms[0].transform.translation.z = stream.states[i].position.z;
    stream.odometry[i].pose.pose.position.z = stream.states[i].position.z;
  }
  expectFailures(stream.judged(), {"position and velocity"},
                 "position is not what the description's translation says; they differ by 9\\.51e-07 m");
}

}  // namespace
}  // namespace poinsot::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
