#pragma once

#include "poinsot/core/rotation_state.h"

/** What FreeRotationState's members of the same names do, inline for steppers, who do it once or more a step. */
namespace poinsot::inlined {

inline Eigen::Vector3d momentumWorld(const FreeRotationState& state) {
  return state.attitude * state.momentum_principal;
}

inline void keepMomentum(FreeRotationState& state, const Eigen::Vector3d& momentum_world) {
  state.kept_momentum = momentum_world;
  const double square = state.kept_momentum.squaredNorm();
  state.kept_inverse_square = square > 0 ? 1 / square : 0;
  state.kept_inverse_inertia = 0;
}

}  // namespace poinsot::inlined
