#pragma once

#include "poinsot/core/rotation_state.h"

/** FreeRotationState's members of the same names, inline because steppers need them at least once a step. */
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
