#include "poinsot/ros/layout_message.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "poinsot/ros/conversions.h"
#include "poinsot/ros/names.h"

namespace poinsot::node {
namespace {

Eigen::AlignedBox3d boxOf(const view::Ball& ball) {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(ball.radius);
  return {Eigen::Vector3d(ball.centre - reach), Eigen::Vector3d(ball.centre + reach)};
}

}  // namespace

bool hasFlownAway(const view::SceneLayout& layout, const std::vector<LaidOut>& bodies) {
  Eigen::AlignedBox3d overview;
  for (const view::Ball& ball : layout.overview) overview.extend(boxOf(ball));
  return std::any_of(bodies.begin(), bodies.end(),
                     [&](const LaidOut& body) { return !overview.intersects(boxOf(body.now)); });
}

SceneLayout layoutMessage(const view::SceneLayout& layout, const std::vector<LaidOut>& bodies) {
  SceneLayout out;
  out.header.frame_id = names::kWorld;
  out.picture_radius = layout.unit;
  out.pitch = layout.pitch;
  std::vector<view::Ball> balls = layout.overview;
  if (hasFlownAway(layout, bodies)) {
    balls.clear();
    for (const LaidOut& body : bodies) balls.push_back(body.now);
  }
  for (const view::Ball& ball : balls) {
    out.centres.push_back(toPoint(ball.centre));
    out.radii.push_back(ball.radius);
  }
  for (const LaidOut& body : bodies) {
    out.bodies.push_back(body.name);
    out.frames.push_back(body.frame);
    if (body.has_pictures) out.pictures.push_back(body.name);
  }
  return out;
}

}  // namespace poinsot::node
