// The parts of the panel that have logic of their own, without ROS and without a window.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include "history.h"
#include "speed_scale.h"
#include "stamp_watch.h"
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

Sample sampleAt(double stamp, double time, unsigned segment = 0) {
  Sample sample;
  sample.stamp = stamp;
  sample.time = time;
  sample.segment = segment;
  return sample;
}

TEST(History, keepsItsWindowOnly) {
  History history(20, 4000);
  for (int i = 0; i <= 60 * 60; ++i) history.add(sampleAt(i / 60.0, i / 60.0));
  EXPECT_NEAR(history[0].stamp, 40, 0.02);
  EXPECT_EQ(history[history.size() - 1].stamp, 60);
  EXPECT_NEAR(static_cast<double>(history.size()), 20 * 60, 3);
}

TEST(History, isBoundedHoweverFastTheNode) {
  History history(20, 4000);
  for (int i = 0; i <= 30 * 10000; ++i) history.add(sampleAt(i / 10000.0, i / 10000.0));
  EXPECT_LE(history.size(), 4002u);
  EXPECT_GT(history.size(), 3800u);
  EXPECT_EQ(history[history.size() - 1].stamp, 30) << "the newest sample is always there";
  for (std::size_t i = 1; i < history.size(); ++i) EXPECT_GT(history[i].stamp, history[i - 1].stamp);
}

TEST(History, aPauseDoesNotPushItOut) {
  History history(20, 4000);
  for (int i = 0; i <= 300; ++i) history.add(sampleAt(i / 60.0, i / 60.0));
  const std::size_t before = history.size();
  for (int i = 1; i <= 6000; ++i) history.add(sampleAt(5 + i / 60.0, 5));
  EXPECT_EQ(history.size(), before);
  history.add(sampleAt(105 + 1 / 60.0, 5 + 1 / 60.0));
  EXPECT_EQ(history.size(), before + 1);
  EXPECT_EQ(history[0].time, 0);
}

TEST(History, aNewSegmentOrAClockThatGoesBackBeginsAnew) {
  History history(20, 4000);
  for (int i = 0; i < 10; ++i) history.add(sampleAt(i, i));
  history.add(sampleAt(10, 500, 1));
  ASSERT_EQ(history.size(), 1u);
  EXPECT_EQ(history[0].time, 500);
  history.add(sampleAt(11, 501, 1));
  history.add(sampleAt(3, 502, 1));
  ASSERT_EQ(history.size(), 1u);
  EXPECT_EQ(history[0].time, 502);
}

TEST(Thinned, keepsThePeaksTheOrderAndTheEnd) {
  std::vector<Point> points;
  for (int i = 0; i < 4000; ++i) points.push_back({static_cast<double>(i), std::sin(0.01 * i)});
  points[1777].y = 9;
  points[2222].y = -9;
  const std::vector<Point> thin = thinned(points, 250);
  EXPECT_LE(thin.size(), 501u);
  double lowest = 0;
  double highest = 0;
  for (std::size_t i = 0; i < thin.size(); ++i) {
    lowest = std::min(lowest, thin[i].y);
    highest = std::max(highest, thin[i].y);
    if (i > 0) {
      EXPECT_GE(thin[i].x, thin[i - 1].x);
    }
  }
  EXPECT_EQ(lowest, -9);
  EXPECT_EQ(highest, 9);
  EXPECT_EQ(thin.back().x, 3999);
}

TEST(Thinned, leavesAFewAlone) {
  const std::vector<Point> points = {{0, 1}, {1, 2}, {2, 0}};
  EXPECT_EQ(thinned(points, 250).size(), 3u);
  EXPECT_TRUE(thinned({}, 250).empty());
}

TEST(StampWatch, noticesThatTimeStandsStill) {
  StampWatch watch;
  for (int i = 0; i < 30; ++i) {
    watch.add(1000 + i, 60, 5 + 0.1 * i);
    EXPECT_FALSE(watch.standsStill()) << i;
  }
  watch.add(1029, 60, 8.8);
  EXPECT_FALSE(watch.standsStill()) << "not yet for a second";
  watch.add(1029, 60, 9.0);
  EXPECT_TRUE(watch.standsStill());
  watch.add(1030, 60, 9.1);
  EXPECT_FALSE(watch.standsStill()) << "it goes on";
  watch.add(500, 60, 10);
  EXPECT_FALSE(watch.standsStill()) << "it jumped back";
  watch.add(500, 60, 11.5);
  EXPECT_TRUE(watch.standsStill());
  watch.clear();
  watch.add(500, 60, 12);
  EXPECT_FALSE(watch.standsStill()) << "another node";
}

TEST(StampWatch, isPatientWithSlowTicks) {
  StampWatch watch;
  watch.add(1, 0.1, 0);
  watch.add(1, 0.1, 29);
  EXPECT_FALSE(watch.standsStill());
  watch.add(1, 0.1, 31);
  EXPECT_TRUE(watch.standsStill());
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

TEST(Worker, doesJobsInTheirOrderAndAnswersByMail) {
  const auto mailbox = std::make_shared<Mailbox>();
  std::vector<int> read;
  std::atomic<int> done{0};
  {
    Worker worker;
    for (int i = 0; i < 5; ++i) {
      worker.post([&, i] {
        mailbox->post([&read, i] { read.push_back(i); });
        ++done;
      });
    }
    while (done < 5) std::this_thread::yield();
    EXPECT_TRUE(read.empty()) << "letters wait until they are read";
    mailbox->read();
  }
  EXPECT_EQ(read, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(Worker, isLeftBehindWhenItHangs) {
  const auto release = std::make_shared<std::atomic<bool>>(false);
  const auto began = std::make_shared<std::atomic<bool>>(false);
  {
    Worker worker;
    worker.post([=] {
      *began = true;
      while (!*release) std::this_thread::yield();
    });
    while (!*began) std::this_thread::yield();
  }  // comes back although the job has not
  EXPECT_FALSE(*release);
  *release = true;
}

}  // namespace
