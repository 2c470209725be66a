#pragma once

#include "poinsot/core/rotation.h"
#include "poinsot/core/rotation_state.h"

namespace poinsot::steppers {

/**
 * The move that all Lie-group methods share: the body turns by the rotation vector θ (body axes) while L stays,
 *   q ← q·exp(θ),  Λ ← exp(−θ)Λ.
 */
inline void rotate(RotationState& state, const Eigen::Vector3d& theta) {
  const Eigen::Quaterniond turn = expQuaternion(theta);
  state.attitude = state.attitude * turn;
  renormalise(state.attitude);
  // exp(−θ)Λ = Λ − 2w(v×Λ) + 2v×(v×Λ)
  const Eigen::Vector3d v = turn.vec();
  const Eigen::Vector3d c = 2.0 * v.cross(state.momentum_body);
  state.momentum_body += v.cross(c) - turn.w() * c;
}

}  // namespace poinsot::steppers
