#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "poinsot/view/path.h"

namespace poinsot::view {
namespace {

Eigen::Vector3d onCircle(double angle) {
  return {std::cos(angle), std::sin(angle), 0};
}

std::size_t pointsOf(const Path& path) {
  std::size_t sum = 0;
  for (std::size_t k = path.firstPiece(); k < path.endPiece(); ++k) sum += path.piece(k).size();
  return sum;
}

double distanceToLine(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double share = std::min(1.0, std::max(0.0, (p - a).dot(b - a) / (b - a).squaredNorm()));
  return (p - a - share * (b - a)).norm();
}

TEST(Path, straightLineIsThinned) {
  Path path(4, 100, 0.002, 0.5);
  for (int i = 0; i <= 1000; ++i) path.add({0.01 * i, 0, 0});
  EXPECT_LT(pointsOf(path), 25u);
  EXPECT_GE(pointsOf(path), 20u);  // none further apart than 0.5
}

TEST(Path, whatIsLeftOutLiesNearWhatIsKept) {
  Path path(64, 256, 0.002, 0.5);
  const int n = 2000;
  for (int i = 0; i <= n; ++i) path.add(onCircle(0.003 * i));
  ASSERT_EQ(path.endPiece(), 1u);
  const auto& kept = path.piece(0);
  EXPECT_LT(kept.size(), 250u);
  for (int i = 0; 0.003 * i < 0.003 * n - 0.2; ++i) {
    double nearest = 1;
    for (std::size_t k = 1; k < kept.size(); ++k)
      nearest = std::min(nearest, distanceToLine(onCircle(0.003 * i), kept[k - 1], kept[k]));
    EXPECT_LT(nearest, 0.0021) << i;
  }
}

TEST(Path, piecesHangTogetherAndTheOldestGo) {
  Path path(3, 10, 1e-6, 0.5);
  for (int i = 0; i <= 400; ++i) {
    path.add(onCircle(0.1 * i));
    EXPECT_LE(path.endPiece() - path.firstPiece(), 3u);
  }
  EXPECT_GT(path.firstPiece(), 10u);
  for (std::size_t k = path.firstPiece(); k < path.endPiece(); ++k) {
    EXPECT_LE(path.piece(k).size(), 10u);
    if (k > path.firstPiece()) {
      EXPECT_EQ(path.piece(k).front(), path.piece(k - 1).back());
      EXPECT_EQ(path.piece(k - 1).size(), 10u);
    }
  }
}

TEST(Path, clearedItBeginsAnew) {
  Path path(3, 10, 1e-6, 0.5);
  for (int i = 0; i <= 100; ++i) path.add(onCircle(0.1 * i));
  path.clear();
  EXPECT_EQ(path.firstPiece(), path.endPiece());
  path.add({1, 2, 3});
  ASSERT_EQ(path.endPiece(), 1u);
  EXPECT_EQ(path.piece(0).front(), Eigen::Vector3d(1, 2, 3));
}

TEST(Path, whatIsNotFiniteIsIgnored) {
  Path path(3, 10, 1e-6, 0.5);
  path.add({std::numeric_limits<double>::quiet_NaN(), 0, 0});
  EXPECT_EQ(path.firstPiece(), path.endPiece());
}

}  // namespace
}  // namespace poinsot::view
