#pragma once

#include <Eigen/Core>
#include <string>

#include "poinsot/core/effects/text.h"
#include "poinsot/core/torques.h"

namespace poinsot {

/** Drag of a thin medium: τᵢ = −cᵢΩᵢ along the body axes. dE/dt = −Σcᵢ Ωᵢ². */
struct ViscousDamping {
  /** The type's name in scene files. */
  static constexpr const char* kName = "viscous_damping";

  Eigen::Vector3d coefficients = Eigen::Vector3d::Zero();  ///< c [N·m·s], not negative

  /** Returns all keys and values as in scene files, with 17 significant digits. */
  std::string text() const { return "coefficient " + effects::text(coefficients); }
  /** Adds its torque to the sum. Throws std::invalid_argument for coefficients that are negative or not finite. */
  void addTo(Torques& torques) const { torques.addDamping(coefficients); }
};

}  // namespace poinsot
