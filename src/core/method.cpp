#include "poinsot/core/method.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "batch_stepper.h"
#include "steppers/buss2.h"
#include "steppers/buss3.h"
#include "steppers/buss4.h"
#include "steppers/cf4.h"
#include "steppers/dmv.h"
#include "steppers/lie_euler.h"
#include "steppers/midpoint.h"
#include "steppers/rk4.h"
#include "steppers/rkmk4.h"
#include "steppers/splitting.h"
#include "torque_steppers/make.h"

namespace poinsot {
namespace {

using batch::make;
using batch::makeKeeping;
using batch::makeKeepingEnergy;

template <class Scheme>
constexpr auto kUnderTorques = torque_steppers::make<Scheme>;

std::vector<Method> those(bool (*wanted)(const Method&)) {
  std::vector<Method> out;
  std::copy_if(methods().begin(), methods().end(), std::back_inserter(out), wanted);
  return out;
}

}  // namespace

const std::vector<Method>& methods() {
  using namespace steppers;
  static const std::vector<Method> table = {
      // name, order, conserves L, conserves E, takes torques that depend on Omega, cuts steps; free, under torques
      {"taylor8", 8, false, false, true, true, nullptr, kUnderTorques<torque_steppers::Taylor<8>>},
      {"taylor12", 12, false, false, true, true, nullptr, kUnderTorques<torque_steppers::Taylor<12>>},
      {"taylor16", 16, false, false, true, true, nullptr, kUnderTorques<torque_steppers::Taylor<16>>},
      {"taylor20", 20, false, false, true, true, nullptr, kUnderTorques<torque_steppers::Taylor<20>>},
      {"taylor24", 24, false, false, true, true, nullptr, kUnderTorques<torque_steppers::Taylor<24>>},
      {"aba84", 4, false, false, false, false, nullptr, kUnderTorques<torque_steppers::Aba84>},
      {"lie_euler", 1, true, false, false, false, makeKeeping<LieEuler>, nullptr},
      {"buss2", 2, true, false, true, false, makeKeeping<Buss2>, kUnderTorques<torque_steppers::Buss2>},
      {"buss3", 3, true, false, false, false, makeKeeping<Buss3>, nullptr},
      {"buss4", 4, true, false, false, false, makeKeeping<Buss4>, nullptr},
      {"rk4", 4, false, false, true, false, make<Rk4>, kUnderTorques<torque_steppers::Rk4>},
      {"rkmk4", 4, true, false, false, false, makeKeeping<Rkmk4>, nullptr},
      {"cf4", 4, true, false, false, false, makeKeeping<Cf4, 4>, nullptr},
      {"midpoint", 2, true, false, false, false, makeKeeping<Midpoint>, nullptr},
      {"splitting2", 2, true, false, false, false, makeKeeping<Splitting2, 2>, nullptr},
      {"splitting4", 4, true, false, false, false, makeKeeping<Splitting4, 1>, nullptr},
      {"splitting6", 6, true, false, false, false, makeKeeping<Splitting6, 1>, nullptr},
      {"dmv2", 2, true, true, false, false, makeKeepingEnergy<Dmv<2>>, nullptr},
      {"dmv4", 4, true, true, false, false, makeKeepingEnergy<Dmv<4>>, nullptr},
      {"dmv6", 6, true, true, false, false, makeKeepingEnergy<Dmv<6>>, nullptr},
      {"dmv8", 8, true, true, false, false, makeKeepingEnergy<Dmv<8>>, nullptr},
      {"dmv10", 10, true, true, false, false, makeKeepingEnergy<Dmv<10>>, nullptr},
  };
  return table;
}

const std::vector<Method>& freeMethods() {
  static const std::vector<Method> list = those([](const Method& method) { return method.make_free != nullptr; });
  return list;
}

const std::vector<Method>& torquedMethods() {
  static const std::vector<Method> list = those([](const Method& method) { return method.make_torqued != nullptr; });
  return list;
}

const Method* findMethod(const std::string& name, const std::vector<Method>& list) {
  for (const Method& method : list) {
    if (name == method.name) return &method;
  }
  return nullptr;
}

std::string methodNames(const std::vector<Method>& list) {
  std::string names;
  for (const Method& method : list) names += (names.empty() ? "" : ", ") + std::string(method.name);
  return names;
}

std::unique_ptr<Stepper> Method::make(const Eigen::Vector3d& moments) const {
  if (make_free) return make_free(moments);
  throw std::invalid_argument(std::string("expected a method that moves free bodies, got ") + name);
}

std::unique_ptr<Stepper> Method::make(const Torques& torques) const {
  if (make_torqued) return make_torqued(torques);
  throw std::invalid_argument(std::string("expected a method that takes torques, got ") + name);
}

std::string objectionTo(const Method& method, const Torques& torques) {
  if (!method.make_torqued) return std::string(method.name) + " takes no torques";
  if (method.takes_damping || torques.dependsOnAttitudeOnly()) return "";
  return std::string(method.name) + " takes torques that depend on time and attitude alone, not damping or dissipation";
}

}  // namespace poinsot
