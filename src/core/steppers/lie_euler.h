#pragma once

#include "poinsot/core/work.h"
#include "steppers/rotate.h"

namespace poinsot::steppers {

/**
 * First order on conserved L: R ← exp(hω)R with ω = R M⁻¹ Rᵀ L, L constant (S. R. Buss, "Accurate and efficient
 * simulation of rigid-body rotations", J. Comput. Phys. 164 (2000) 377–406, the first-order method).
 *
 * Written in body axes: θ = hΩ. Conserves L. E never falls and rises by (h²/2)(Λ×Ω)ᵀM⁻¹(Λ×Ω) + O(h³) a step, so every
 * start ends about the axis of smallest moment: the opposite of dissipation.
 */
class LieEuler {
 public:
  static constexpr Work kWork = {1, 1};  ///< of a step

  explicit LieEuler(const Eigen::Vector3d& moments) : inverse_(moments.cwiseInverse()) {}

  void step(FreeRotationState& state, double h) const {
    const Eigen::Vector3d& p = state.momentum_principal;
    rotate(state, {(h * inverse_[0]) * p[0], (h * inverse_[1]) * p[1], (h * inverse_[2]) * p[2]});
  }

 private:
  Eigen::Vector3d inverse_;
};

}  // namespace poinsot::steppers
