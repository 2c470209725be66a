#pragma once

#include <string>

#include "poinsot/core/effects/text.h"
#include "poinsot/core/torques.h"

namespace poinsot {

/**
 * Energy lost inside a body that nothing acts on, by Kane's damper: a spherical slug in a viscous film, of inertia J,
 * its rate σ in body axes equal to Ω at the start (T. R. Kane, D. A. Levinson, Dynamics: Theory and Applications, 1985,
 * and earlier; in Hughes, Spacecraft Attitude Dynamics, 1986): MΩ̇ = MΩ×Ω − c(Ω − σ),   J(σ̇ + Ω×σ) = c(Ω − σ). The total
 * L = R(MΩ + Jσ) is constant; E + ½Jσ² falls by c|Ω − σ|² a second, until the body spins about its axis of largest
 * moment, as Explorer 1 did.
 */
struct InternalDissipation {
  /** The type's name in scene files. */
  static constexpr const char* kName = "internal_dissipation";

  double slug_inertia = 0;  ///< J [kg·m²], positive
  double damping = 0;       ///< c [N·m·s], not negative

  /** Returns all keys and values as in scene files, with 17 significant digits. */
  std::string text() const {
    return "slug_inertia " + effects::text(slug_inertia) + ", damping " + effects::text(damping);
  }
  /** Adds its torque to the sum. Throws std::invalid_argument for a second slug and for values not allowed above. */
  void addTo(Torques& torques) const { torques.addSlug(slug_inertia, damping); }
};

}  // namespace poinsot
