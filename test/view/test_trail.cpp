#include <gtest/gtest.h>

#include <limits>

#include "poinsot/view/trail.h"

namespace poinsot::view {
namespace {

Eigen::Vector3d at(double x) {
  return {x, 0, 0};
}

std::vector<double> xs(const Trail& trail) {
  std::vector<double> out;
  for (std::size_t i = 0; i < trail.size(); ++i) out.push_back(trail[i].x());
  return out;
}

using Xs = std::vector<double>;

TEST(Trail, oldestFirst) {
  Trail trail(10, 100, 0.5);
  EXPECT_TRUE(trail.empty());
  for (int i = 0; i < 4; ++i) trail.add(at(i));
  EXPECT_EQ(xs(trail), (Xs{0, 1, 2, 3}));
}

TEST(Trail, capacityDropsTheOldest) {
  Trail trail(3, 100, 0.5);
  for (int i = 0; i < 100; ++i) {
    trail.add(at(i));
    EXPECT_LE(trail.size(), 3u);
  }
  EXPECT_EQ(xs(trail), (Xs{97, 98, 99}));
}

TEST(Trail, isNoLongerThanItsLength) {
  Trail trail(100, 2.5, 0.5);
  for (int i = 0; i < 10; ++i) trail.add(at(i));
  EXPECT_EQ(xs(trail), (Xs{7, 8, 9}));
}

TEST(Trail, turningRoundCountsThePath) {
  Trail trail(100, 2.5, 0.5);
  for (const double x : {0.0, 1.0, 2.0, 1.0, 0.0}) trail.add(at(x));
  EXPECT_EQ(xs(trail), (Xs{2, 1, 0}));  // the first two lie near, but 4 and 3 back along the path
}

TEST(Trail, coarsePointsDoNotMakeItLonger) {
  Trail trail(1000, 10, 0.01);
  for (int i = 0; i < 100; ++i) {
    trail.add(at(3 * i));
    EXPECT_LE(trail[trail.size() - 1].x() - trail[0].x(), 10);
  }
}

TEST(Trail, spacingThinsButTheNewestIsAlwaysThere) {
  Trail trail(1000, 100, 1.0);
  for (int i = 0; i <= 1005; ++i) {
    trail.add(at(0.01 * i));
    EXPECT_EQ(trail[trail.size() - 1].x(), 0.01 * i);
  }
  ASSERT_EQ(trail.size(), 12u);
  for (std::size_t i = 1; i + 1 < trail.size(); ++i) EXPECT_GE(trail[i].x() - trail[i - 1].x(), 1.0);
}

TEST(Trail, standingStillAddsNothing) {
  Trail trail(10, 100, 0.0);
  for (int i = 0; i < 5; ++i) trail.add(at(1));
  EXPECT_EQ(xs(trail), (Xs{1}));
}

TEST(Trail, clearStartsAnew) {
  Trail trail(10, 2, 0.5);
  trail.add(at(0));
  trail.add(at(1));
  trail.clear();
  EXPECT_TRUE(trail.empty());
  trail.add(at(5));  // a jump that clear() goes with does not count as time played
  trail.add(at(6));
  EXPECT_EQ(xs(trail), (Xs{5, 6}));
}

TEST(Trail, ignoresWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Trail trail(10, 2, 0.5);
  trail.add(at(0));
  trail.add(at(nan));
  EXPECT_EQ(xs(trail), (Xs{0}));
}

}  // namespace
}  // namespace poinsot::view
