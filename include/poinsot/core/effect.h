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
 * Anything that turns a body. (Translation does not, and stands apart.) To add an effect, write its file and add its
 * type to this variant; doc/adding_an_effect.md has the rest.
 */
using Effect =
    std::variant<ConstantTorque, GravityTorque, GravityGradient, ViscousDamping, InternalDissipation, TorqueSchedule>;

/** The type's name in scene files. */
std::string nameOf(const Effect& effect);

/** "type: key value, key value": all keys and values, with 17 significant digits, from which they can be read back. */
std::string textOf(const Effect& effect);

/**
 * The sum of the effects on a body of that inertia. Throws std::invalid_argument where two of them exclude each other
 * (a second orbit, a second slug) or a value is out of range.
 */
Torques sumOf(const PrincipalInertia& inertia, const std::vector<Effect>& effects);

}  // namespace poinsot
