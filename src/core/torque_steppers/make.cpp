#include "torque_steppers/make.h"

#include "torque_steppers/aba84.h"
#include "torque_steppers/buss2.h"
#include "torque_steppers/rk4.h"
#include "torque_steppers/taylor.h"

namespace poinsot::torque_steppers {

template <class Scheme>
std::unique_ptr<Stepper> make(const Torques& torques) {
  return std::make_unique<Scheme>(torques);
}

template std::unique_ptr<Stepper> make<Aba84>(const Torques&);
template std::unique_ptr<Stepper> make<Buss2>(const Torques&);
template std::unique_ptr<Stepper> make<Rk4>(const Torques&);
template std::unique_ptr<Stepper> make<Taylor<8>>(const Torques&);
template std::unique_ptr<Stepper> make<Taylor<12>>(const Torques&);
template std::unique_ptr<Stepper> make<Taylor<16>>(const Torques&);
template std::unique_ptr<Stepper> make<Taylor<20>>(const Torques&);
template std::unique_ptr<Stepper> make<Taylor<24>>(const Torques&);

}  // namespace poinsot::torque_steppers
