#pragma once

#include <Eigen/Core>
#include <string>

#include "poinsot/core/effects/text.h"
#include "poinsot/core/torques.h"

namespace poinsot {

/**
 * The torque of a central field's gradient on a small body in circular orbit: τ = 3n² u × Mu, u = Rᵀr(t), r the
 * direction from the centre, turning at the rate n about the orbit's normal (P. C. Hughes, Spacecraft Attitude
 * Dynamics, 1986, §8.1). E − nN·L + (3/2)n² uᵀMu is constant.
 */
struct GravityGradient {
  /** The type's name in scene files. */
  static constexpr const char* kName = "gravity_gradient";

  double orbit_rate = 0;                                       ///< n [rad/s], positive
  Eigen::Vector3d orbit_normal = Eigen::Vector3d::UnitZ();     ///< N, world axes, of any length but 0
  Eigen::Vector3d radial_at_start = Eigen::Vector3d::UnitX();  ///< r(0), world axes, perpendicular to N

  /** Returns all keys and values as in scene files, with 17 significant digits. */
  std::string text() const {
    return "orbit_rate " + effects::text(orbit_rate) + ", orbit_normal " + effects::text(orbit_normal) +
           ", radial_at_start " + effects::text(radial_at_start);
  }
  /** Adds its torque to the sum. Throws std::invalid_argument for a second orbit and for values not allowed above. */
  void addTo(Torques& torques) const { torques.addGravityGradient(orbit_rate, orbit_normal, radial_at_start); }
};

}  // namespace poinsot
