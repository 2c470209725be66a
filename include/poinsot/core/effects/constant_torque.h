#pragma once

#include <Eigen/Core>
#include <string>

#include "poinsot/core/effects/text.h"
#include "poinsot/core/torques.h"

namespace poinsot {

/**
 * A torque that is constant in body axes (a leaking thruster) or in world axes; in these, L(t) = L₀ + τt whatever the
 * attitude.
 */
struct ConstantTorque {
  /** The type's name in scene files. */
  static constexpr const char* kName = "constant_torque";

  Axes axes = Axes::body;                            ///< in which it is constant
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< [N·m]

  /** Returns all keys and values as in scene files, with 17 significant digits. */
  std::string text() const {
    return std::string("frame ") + (axes == Axes::body ? "body" : "world") + ", torque " + effects::text(torque);
  }
  /** Adds its torque to the sum. Throws std::invalid_argument for a torque that is not finite. */
  void addTo(Torques& torques) const { torques.addConstant(axes, torque); }
};

}  // namespace poinsot
