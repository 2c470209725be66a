#pragma once

#include <Eigen/Core>
#include <vector>

namespace poinsot::view {

/** A polyline in Ω-space (principal axes, rad/s). A closed one does not repeat its first point. */
struct Curve {
  std::vector<Eigen::Vector3d> points;
  bool closed = false;
};

}  // namespace poinsot::view
