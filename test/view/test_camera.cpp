// The camera of the overview: it shows all, and from no farther than it must.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "poinsot/view/camera.h"

namespace poinsot::view {
namespace {

/** How far the ball is inside of the picture, as a share of its half width or height; negative: it is cut off. */
double roomOf(const Ball& ball, const OrbitCamera& camera, double pitch, double yaw, double aspect) {
  // As RViz's Orbit view stands, doc of rviz::OrbitViewController: the eye in spherical coordinates about the focus.
  const Eigen::Vector3d back(std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch));
  const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(back).normalized(), up = back.cross(right);
  const Eigen::Vector3d from_eye = ball.centre - (camera.focal + camera.distance * back);
  const double depth = -from_eye.dot(back);
  if (depth <= ball.radius) return -1;
  double room = 1;
  for (const auto& [across, tangent] : {std::pair{from_eye.dot(right), aspect * std::tan(0.5 * kFieldOfView)},
                                        std::pair{from_eye.dot(up), std::tan(0.5 * kFieldOfView)}}) {
    // The edge of the ball, seen from the eye, is where a plane through the eye touches it.
    const double angle = std::atan2(std::abs(across), depth) + std::asin(ball.radius / std::hypot(across, depth));
    room = std::min(room, 1 - std::tan(angle) / tangent);
  }
  return room;
}

struct Draw {
  std::vector<Ball> balls;
  double pitch, yaw, aspect;
};

Draw drawn(std::mt19937_64& engine) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Draw out{{}, 1.2 * unit(engine), M_PI * unit(engine), 1.6 + unit(engine)};
  const double size = std::pow(10, 4 * unit(engine));
  const int count = 1 + static_cast<int>(engine() % 12);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d centre(unit(engine), 3 * unit(engine), unit(engine));
    out.balls.push_back({size * centre, size * (0.01 + 0.5 * std::abs(unit(engine)))});
  }
  return out;
}

TEST(Camera, showsAllFromNoFartherThanItMust) {
  std::mt19937_64 engine(7);
  for (int i = 0; i < 300; ++i) {
    const Draw draw = drawn(engine);
    const OrbitCamera camera = cameraThatShows(draw.balls, draw.pitch, draw.yaw, draw.aspect);
    double least = 1;
    for (const Ball& ball : draw.balls)
      least = std::min(least, roomOf(ball, camera, draw.pitch, draw.yaw, draw.aspect));
    EXPECT_GT(least, 0.01) << "something is cut off, or nearly";
    EXPECT_LT(least, 0.05) << "it is farther away than it must be";
  }
}

TEST(Camera, aCameraThatIsNearerCutsSomethingOff) {  // so the test above can fail
  std::mt19937_64 engine(8);
  for (int i = 0; i < 50; ++i) {
    const Draw draw = drawn(engine);
    OrbitCamera camera = cameraThatShows(draw.balls, draw.pitch, draw.yaw, draw.aspect);
    camera.distance *= 0.9;
    double least = 1;
    for (const Ball& ball : draw.balls)
      least = std::min(least, roomOf(ball, camera, draw.pitch, draw.yaw, draw.aspect));
    EXPECT_LT(least, 0.01);
  }
}

TEST(Camera, looksAtAPointAndAtNothing) {
  EXPECT_GT(cameraThatShows({}, 0.3, 0, 1.6).distance, 0);
  const OrbitCamera camera = cameraThatShows({{{1, 2, 3}, 0}}, 0.3, 0, 1.6);
  EXPECT_GT(camera.distance, 0);
  EXPECT_TRUE(camera.focal.isApprox(Eigen::Vector3d(1, 2, 3), 1e-9)) << camera.focal.transpose();
}

}  // namespace
}  // namespace poinsot::view
