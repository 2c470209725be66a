#include "poinsot/core/invariants.h"

#include "kept_momentum.h"

namespace poinsot {
namespace {

double ratio(double difference, double reference) {
  return difference == 0 ? 0 : difference / reference;
}

}  // namespace

Invariants invariantsOf(const Eigen::Vector3d& moments, const FreeRotationState& state) {
  return {0.5 * state.momentum_principal.dot(state.omegaPrincipal(moments)), state.momentum_principal.squaredNorm(),
          inlined::momentumWorld(state)};
}

double energyDrift(const Invariants& now, const Invariants& reference) {
  return ratio(now.kinetic_energy - reference.kinetic_energy, reference.kinetic_energy);
}

double momentumDrift(const Invariants& now, const Invariants& reference) {
  return ratio((now.momentum_world - reference.momentum_world).norm(), reference.momentum_world.norm());
}

}  // namespace poinsot
