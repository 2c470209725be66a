#pragma once

#include <Eigen/Core>
#include <string>

#include "poinsot/core/effects/text.h"
#include "poinsot/core/torques.h"

namespace poinsot {

/**
 * The weight of a body with a fixed pivot (heavy top, pendulum): τ = c × Rᵀ(mg). The body's moments are those about the
 * pivot. E − mg·Rc is constant, and so is the component of L along g; Ω₃ of a Lagrange top as well.
 */
struct GravityTorque {
  /** The type's name in scene files. */
  static constexpr const char* kName = "gravity_torque";

  double mass = 1;                                           ///< m [kg], positive
  Eigen::Vector3d gravity = {0, 0, -9.80665};                ///< g [m/s²], world axes
  Eigen::Vector3d centre_of_mass = Eigen::Vector3d::Zero();  ///< c [m], body axes, from the pivot

  /** Returns all keys and values as in scene files, with 17 significant digits. */
  std::string text() const {
    return "mass " + effects::text(mass) + ", gravity " + effects::text(gravity) + ", centre_of_mass " +
           effects::text(centre_of_mass);
  }
  /** Adds its torque to the sum. Throws std::invalid_argument for values that are not finite. */
  void addTo(Torques& torques) const { torques.addForce(centre_of_mass, mass * gravity); }
};

}  // namespace poinsot
