#pragma once

#include <Eigen/Core>
#include <string>

#include "poinsot/core/effects/text.h"
#include "poinsot/core/torques.h"

namespace poinsot {

/** Drag of a thin medium: τᵢ = −cᵢΩᵢ along the body axes. dE/dt = −Σcᵢ Ωᵢ². */
struct ViscousDamping {
  static constexpr const char* kName = "viscous_damping";

  Eigen::Vector3d coefficients = Eigen::Vector3d::Zero();  ///< c [N·m·s], not negative

  std::string text() const { return "coefficient " + effects::text(coefficients); }
  void addTo(Torques& torques) const { torques.addDamping(coefficients); }
};

}  // namespace poinsot
