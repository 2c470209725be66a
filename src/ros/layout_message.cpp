#include "poinsot/ros/layout_message.h"

#include <algorithm>

#include "poinsot/ros/conversions.h"
#include "poinsot/ros/names.h"

namespace poinsot::node {
namespace {

bool isWithin(const view::SceneLayout& layout, const view::Ball& body) {
  Eigen::Vector3d low = body.centre, high = body.centre;
  for (const view::Ball& ball : layout.overview) {
    low = low.cwiseMin(ball.centre - Eigen::Vector3d::Constant(ball.radius));
    high = high.cwiseMax(ball.centre + Eigen::Vector3d::Constant(ball.radius));
  }
  return (body.centre.array() >= low.array() - body.radius).all() &&
         (body.centre.array() <= high.array() + body.radius).all();
}

}  // namespace

bool hasFlownAway(const view::SceneLayout& layout, const std::vector<view::Ball>& bodies) {
  return std::any_of(bodies.begin(), bodies.end(), [&](const view::Ball& body) { return !isWithin(layout, body); });
}

SceneLayout layoutMessage(const view::SceneLayout& layout, const std::vector<std::string>& pictures,
                          const std::vector<view::Ball>& bodies) {
  SceneLayout out;
  out.header.frame_id = names::kWorld;
  out.picture_radius = layout.unit;
  out.pitch = layout.pitch;
  for (const view::Ball& ball : hasFlownAway(layout, bodies) ? bodies : layout.overview) {
    out.centres.push_back(toPoint(ball.centre));
    out.radii.push_back(ball.radius);
  }
  out.pictures = pictures;
  return out;
}

}  // namespace poinsot::node
