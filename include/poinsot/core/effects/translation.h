#pragma once

#include <Eigen/Core>
#include <string>

#include "poinsot/core/effects/text.h"

namespace poinsot {

/**
 * Uniformly accelerated motion of the centre of mass, b(t) = b₀ + v₀t + ½at², in world axes [m, m/s, m/s²]. It is in
 * closed form and does not depend on the rotation, nor the rotation on it.
 */
struct Translation {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();      ///< b₀, at t = 0 [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();      ///< v₀, at t = 0 [m/s]
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< a [m/s²]

  /** The type's name in scene files. */
  static constexpr const char* kName = "translation";

  /** Returns all keys and values as in scene files, with 17 significant digits. */
  std::string text() const {
    return "position " + effects::text(position) + ", velocity " + effects::text(velocity) + ", acceleration " +
           effects::text(acceleration);
  }

  /** Returns b(t) [m], world axes. */
  Eigen::Vector3d positionAt(double t) const;
  /** Returns db/dt [m/s], world axes. */
  Eigen::Vector3d velocityAt(double t) const;
};

}  // namespace poinsot
