#include "poinsot/core/rotation_state.h"

#include "kept_momentum.h"

namespace poinsot {

RotationState RotationState::fromOmega(const Eigen::Vector3d& moments, const Quaternion& attitude,
                                       const Eigen::Vector3d& omega_body) {
  RotationState state;
  state.attitude = attitude;
  state.momentum_body = moments.cwiseProduct(omega_body);
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
