#pragma once

#include <string>
#include <variant>
#include <vector>

#include "poinsot/core/effects/constant_torque.h"
#include "poinsot/core/effects/gravity_gradient.h"
#include "poinsot/core/effects/gravity_torque.h"
#include "poinsot/core/effects/internal_dissipation.h"
#include "poinsot/core/effects/torque_schedule.h"
#include "poinsot/core/effects/viscous_damping.h"
#include "poinsot/core/torques.h"

namespace poinsot {

/**
 * Anything that turns a body; translation, which does not, is not among them. To add an effect, write its file and add
 * its type to this variant; doc/adding_an_effect.md has the rest.
 */
using Effect =
    std::variant<ConstantTorque, GravityTorque, GravityGradient, ViscousDamping, InternalDissipation, TorqueSchedule>;

/** Returns the type's name in scene files. */
std::string nameOf(const Effect& effect);

/** Returns "type: key value, key value", with 17 significant digits, from which the effect can be read back. */
std::string textOf(const Effect& effect);

/**
 * Returns the sum of the effects on a body of that inertia. Throws std::invalid_argument where two of them exclude each
 * other (a second orbit, a second slug) or a value is out of range.
 */
Torques sumOf(const PrincipalInertia& inertia, const std::vector<Effect>& effects);

}  // namespace poinsot
