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
  Eigen::Vector3d position = Eigen::Vector3d::Zero();      ///< b₀, at t = 0 [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();      ///< v₀, at t = 0 [m/s]
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< a [m/s²]

  /** The type's name in scene files. */
  static constexpr const char* kName = "translation";

  /** All keys and values, as scene files have them, with 17 significant digits. */
  std::string text() const {
    return "position " + effects::text(position) + ", velocity " + effects::text(velocity) + ", acceleration " +
           effects::text(acceleration);
  }

  /** b(t) [m], world axes. */
  Eigen::Vector3d positionAt(double t) const;
  /** db/dt [m/s], world axes. */
  Eigen::Vector3d velocityAt(double t) const;
};

}  // namespace poinsot
