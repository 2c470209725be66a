#pragma once

#include <memory>

#include "poinsot/core/stepper.h"
#include "poinsot/core/torques.h"

namespace poinsot::torque_steppers {

class Aba84;
class Buss2;
class Rk4;
template <int order>
class Taylor;

/** Binds one of the above to a body under torques; instantiated in make.cpp, for each of them. */
template <class Scheme>
std::unique_ptr<Stepper> make(const Torques& torques);

}  // namespace poinsot::torque_steppers
