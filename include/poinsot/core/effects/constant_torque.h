#pragma once

#include <Eigen/Core>
#include <string>

#include "poinsot/core/effects/text.h"
#include "poinsot/core/torques.h"

namespace poinsot {

/** A torque that is constant in the body (a leaking thruster) or in the world; then L(t) = L₀ + τt, whatever the body
 * does. */
struct ConstantTorque {
  static constexpr const char* kName = "constant_torque";

  Axes axes = Axes::body;
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< [N·m]

  std::string text() const {
    return std::string("frame ") + (axes == Axes::body ? "body" : "world") + ", torque " + effects::text(torque);
  }
  void addTo(Torques& torques) const { torques.addConstant(axes, torque); }
};

}  // namespace poinsot
