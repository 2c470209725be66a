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

/** Anything that turns a body. (Translation does not, and stands apart.) A new effect is a file and a word here. */
using Effect =
    std::variant<ConstantTorque, GravityTorque, GravityGradient, ViscousDamping, InternalDissipation, TorqueSchedule>;

/** The type's name in scene files. */
std::string nameOf(const Effect& effect);

/** "type: key value, key value", all keys and values, for whoever wants to read them back. */
std::string textOf(const Effect& effect);

/** What they add up to; throws std::invalid_argument where two of them do not go together or a value is out of range.
 */
Torques sumOf(const PrincipalInertia& inertia, const std::vector<Effect>& effects);

}  // namespace poinsot
