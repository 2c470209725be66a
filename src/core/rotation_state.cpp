#include "poinsot/core/rotation_state.h"

#include "kept_momentum.h"

namespace poinsot {

RotationState RotationState::fromOmega(const Eigen::Vector3d& moments, const Quaternion& attitude,
                                       const Eigen::Vector3d& omega_principal) {
  RotationState state;
  state.attitude = attitude;
  state.momentum_principal = moments.cwiseProduct(omega_principal);
  state.keepMomentum();
  return state;
}

void FreeRotationState::keepMomentum() {
  inlined::keepMomentum(*this, inlined::momentumWorld(*this));
}

void FreeRotationState::keepMomentum(const Eigen::Vector3d& momentum_world) {
  inlined::keepMomentum(*this, momentum_world);
}

Eigen::Vector3d FreeRotationState::momentumWorld() const {
  return inlined::momentumWorld(*this);
}

}  // namespace poinsot
