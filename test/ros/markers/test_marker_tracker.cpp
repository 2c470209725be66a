#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "poinsot/ros/markers/body_picture.h"
#include "poinsot/ros/markers/marker_tracker.h"
#include "poinsot/scene/motion_setup.h"
#include "poinsot/scene/reader.h"
#include "poinsot/session/moving_body.h"

namespace poinsot::node {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

using Keys = std::set<std::pair<std::string, int>>;

Marker marker(const std::string& ns, int id, int action = Marker::ADD) {
  Marker out;
  out.ns = ns;
  out.id = id;
  out.action = action;
  return out;
}

MarkerArray arrayOf(const std::vector<Marker>& markers) {
  MarkerArray out;
  out.markers = markers;
  return out;
}

Keys keysOf(const MarkerArray& array, int action) {
  Keys out;
  for (const Marker& m : array.markers) {
    if (m.action == action) out.insert({m.ns, m.id});
  }
  return out;
}

TEST(MarkerTracker, deletesWhatIsToGoUnlessItIsPutAgain) {
  MarkerTracker tracker;
  MarkerArray first = arrayOf({marker("a/x", 0), marker("a/x", 1), marker("a/y", 0), marker("ab/x", 0)});
  tracker.follow(first);
  EXPECT_TRUE(keysOf(first, Marker::DELETE).empty());
  tracker.withdraw("a");
  MarkerArray second = arrayOf({marker("a/x", 1)});
  tracker.follow(second);
  EXPECT_EQ(keysOf(second, Marker::DELETE), (Keys{{"a/x", 0}, {"a/y", 0}})) << "of no other body";
  EXPECT_EQ(second.markers.back().action, Marker::ADD) << "first it deletes, then it puts";
  MarkerArray third;
  tracker.follow(third);
  EXPECT_TRUE(third.markers.empty()) << "once";
  tracker.withdrawAll();
  tracker.follow(third);
  EXPECT_EQ(keysOf(third, Marker::DELETE), (Keys{{"a/x", 1}, {"ab/x", 0}}));
}

TEST(MarkerTracker, notesWhatAnArrayDeletesItself) {
  MarkerTracker tracker;
  MarkerArray array = arrayOf({marker("a/x", 0)});
  tracker.follow(array);
  array = arrayOf({marker("a/x", 0, Marker::DELETE)});
  tracker.follow(array);
  tracker.withdrawAll();
  array = {};
  tracker.follow(array);
  EXPECT_TRUE(array.markers.empty());
}

TEST(MarkerTracker, deletionsWaitForNoFrameOfABody) {
  MarkerTracker tracker;
  tracker.withdrawLeftovers({"a"});
  MarkerArray array;
  tracker.follow(array);
  ASSERT_FALSE(array.markers.empty());
  for (const Marker& m : array.markers) {
    EXPECT_EQ(m.header.frame_id, "world");
    EXPECT_TRUE(m.header.stamp.isZero());
  }
}

// All that any scene draws would be deleted when its node is killed and another one takes its place.
TEST(MarkerTracker, leftoversHoldAllThatIsEverDrawn) {
  int scenes = 0;
  std::set<std::string> drawn_in;
  for (const auto& file : std::filesystem::directory_iterator(SCENES)) {
    if (file.path().extension() != ".yaml") continue;
    ++scenes;
    const scene::Scene scene = scene::readFile(file.path());
    for (scene::Body body : scene.bodies) {
      if (body.accuracy) {  // it is drawn alike by every method
        body.method = body.effects.empty() ? "rk4" : "taylor8";
        body.step = 0.01;
      }
      std::map<std::string, int> spaces = markerSpaces(body.name);
      session::MovingBody moving(body);
      BodyPicture picture(body, moving.motion(), names::Frames("", body.name), BodyPicture::Detail::pictures);
      SceneFacts facts;
      facts.loop = scene.loop;
      layOutScene({&picture}, facts);
      MarkerArray markers;
      picture.appendStatic(markers);
      for (int k = 0; k < 200; ++k) {
        const session::Tick tick{(k + 1) * session::kSecond / 20, 0.05 * k, 1, 0};
        moving.move(tick);
        picture.appendMoving(tick, moving.motion(), moving.state(), markers);
        picture.appendFigures(tick, {0, 0, 0, 0}, markers);
      }
      for (const Marker& m : markers.markers) {
        drawn_in.insert(m.ns.substr(m.ns.find('/')));
        EXPECT_LT(m.id, spaces[m.ns]) << file.path() << ": " << m.ns;
      }
    }
  }
  EXPECT_GT(scenes, 15);
  std::set<std::string> all;
  for (const auto& [ns, ids] : markerSpaces("")) all.insert(ns);
  EXPECT_EQ(drawn_in, all) << "namespaces in which nothing is ever drawn need no deletions";
}

}  // namespace
}  // namespace poinsot::node
