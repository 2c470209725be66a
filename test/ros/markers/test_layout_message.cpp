// What ~layout says: the whole scene while its bodies are in it, and the bodies alone when one has flown away.
#include <gtest/gtest.h>

#include "poinsot/ros/layout_message.h"

namespace poinsot::node {
namespace {

view::SceneLayout layoutOfOne() {
  view::SceneLayout out;
  out.unit = 0.5;
  out.overview = {{{0, 0, 0}, 1}, {{0, 4, 0}, 1}};
  return out;
}

LaidOut bodyAt(double y) {
  return {"wing", "robot/wing", true, {{0, y, 0}, 0.7}};
}

TEST(LayoutMessage, hasTheWholeSceneWhileItsBodiesAreInIt) {
  const SceneLayout message = layoutMessage(layoutOfOne(), {bodyAt(0)});
  ASSERT_EQ(message.centres.size(), 2u);
  EXPECT_EQ(message.centres[1].y, 4);
  EXPECT_EQ(message.picture_radius, 0.5);
  EXPECT_EQ(message.bodies, std::vector<std::string>{"wing"});
  EXPECT_EQ(message.frames, std::vector<std::string>{"robot/wing"});
  EXPECT_EQ(message.pictures, std::vector<std::string>{"wing"});
  EXPECT_FALSE(hasFlownAway(layoutOfOne(), {bodyAt(5.5)})) << "a part of it is still there";
}

TEST(LayoutMessage, followsABodyThatFliesAway) {
  EXPECT_TRUE(hasFlownAway(layoutOfOne(), {bodyAt(0), bodyAt(6)}));
  const SceneLayout message = layoutMessage(layoutOfOne(), {bodyAt(100)});
  ASSERT_EQ(message.centres.size(), 1u);
  EXPECT_EQ(message.centres[0].y, 100);
  EXPECT_EQ(message.radii[0], 0.7);
}

}  // namespace
}  // namespace poinsot::node
