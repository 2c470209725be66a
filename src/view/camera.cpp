#include "poinsot/view/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace poinsot::view {
namespace {

constexpr double kMargin = 0.97;
constexpr int kHalvings = 60;

/** Where the focal point may lie, sideways and upwards, so that all is seen; `low` exceeds `high` where it cannot. */
struct Room {
  Eigen::Array2d low = Eigen::Array2d::Constant(-std::numeric_limits<double>::infinity());
  Eigen::Array2d high = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
};

/** @param balls with coordinates towards the eye, to its right, and upwards; the focal plane is at 0 of the first. */
Room roomAt(double distance, const std::vector<Ball>& balls, const Eigen::Array2d& tangents) {
  Room room;
  for (const Ball& ball : balls) {
    // A cone of this opening touches a ball that is so far inside of it.
    const Eigen::Array2d half = (distance - ball.centre.x()) * tangents - ball.radius * (1 + tangents.square()).sqrt();
    room.low = room.low.max(ball.centre.tail<2>().array() - half);
    room.high = room.high.min(ball.centre.tail<2>().array() + half);
  }
  return room;
}

}  // namespace

OrbitCamera cameraThatShows(const std::vector<Ball>& balls, double pitch, double yaw, double aspect) {
  if (balls.empty()) return {};
  const Eigen::Matrix3d to_world =
      (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(-pitch, Eigen::Vector3d::UnitY()))
          .toRotationMatrix();
  std::vector<Ball> seen = balls;
  double nearest = -std::numeric_limits<double>::infinity(), size = 0;
  for (Ball& ball : seen) {
    ball.centre = to_world.transpose() * ball.centre;
    nearest = std::max(nearest, ball.centre.x() + ball.radius);
  }
  for (const Ball& ball : seen) {
    size = std::max(size, (ball.centre - seen.front().centre).norm() + ball.radius);
  }
  const double vertical = kMargin * std::tan(0.5 * kFieldOfView);
  const Eigen::Array2d tangents(vertical * aspect, vertical);
  // The focal point lies in the plane through the mean depth, so that orbiting turns about what is seen.
  double depth = 0;
  for (const Ball& ball : seen) depth += ball.centre.x() / static_cast<double>(seen.size());
  for (Ball& ball : seen) ball.centre.x() -= depth;

  double near = std::max(0.0, nearest - depth), far = near + 4 * size * (1 + 1 / tangents.minCoeff());
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (near + far);
    const Room room = roomAt(middle, seen, tangents);
    ((room.low <= room.high).all() ? far : near) = middle;
  }
  const Room room = roomAt(far, seen, tangents);
  const Eigen::Array2d focal = 0.5 * (room.low + room.high);
  return {std::max(far, std::numeric_limits<double>::min()), to_world * Eigen::Vector3d(depth, focal.x(), focal.y())};
}

}  // namespace poinsot::view
