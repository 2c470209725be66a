#pragma once

#include <Eigen/Core>
#include <string>

#include "poinsot/core/effects/text.h"

namespace poinsot {

/**
 * Uniformly accelerated motion of the centre of mass, b(t) = b₀ + v₀t + ½at², in world axes [m, m/s, m/s²]. It is in
 * closed form and does not know the rotation, nor the rotation it.
 */
struct Translation {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();

  static constexpr const char* kName = "translation";

  std::string text() const {
    return "position " + effects::text(position) + ", velocity " + effects::text(velocity) + ", acceleration " +
           effects::text(acceleration);
  }

  Eigen::Vector3d positionAt(double t) const { return position + t * (velocity + (0.5 * t) * acceleration); }
  Eigen::Vector3d velocityAt(double t) const { return velocity + t * acceleration; }
};

}  // namespace poinsot
