#include "poinsot/core/stepper.h"

#include "poinsot/core/steppers/buss2.h"
#include "poinsot/core/steppers/lie_euler.h"
#include "poinsot/core/steppers/rk4.h"

namespace poinsot {
namespace {

/** Runs a method's inline step() in a plain loop. */
template <class Scheme>
class BatchStepper final : public Stepper {
 public:
  explicit BatchStepper(const Eigen::Vector3d& moments) : scheme_(moments) {}

  void advance(RotationState& state, double step, std::int64_t count) const override {
    RotationState s = state;
    for (std::int64_t i = 0; i < count; ++i) scheme_.step(s, step);
    state = s;
  }

 private:
  Scheme scheme_;
};

template <class Scheme>
std::unique_ptr<Stepper> make(const Eigen::Vector3d& moments) {
  return std::make_unique<BatchStepper<Scheme>>(moments);
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> table = {
      // name, order, conserves L, conserves E
      {"lie_euler", 1, true, false, make<steppers::LieEuler>},
      {"buss2", 2, true, false, make<steppers::Buss2>},
      {"rk4", 4, false, false, make<steppers::Rk4>},
  };
  return table;
}

const Method* findMethod(const std::string& name) {
  for (const Method& method : methods()) {
    if (name == method.name) return &method;
  }
  return nullptr;
}

std::string methodNames() {
  std::string names;
  for (const Method& method : methods()) names += (names.empty() ? "" : ", ") + std::string(method.name);
  return names;
}

}  // namespace poinsot
