#pragma once

#include "poinsot/core/work.h"
#include "steppers/rotate.h"
#include "steppers/taylor.h"

namespace poinsot::steppers {

/**
 * Fourth order, one exponential a step: buss3 with one term more. From θ' = Ω + ½θ×Ω + (1/12)θ×(θ×Ω) + …, which is
 * R' = R hat(Ω) for R = R₀exp(θ) (Iserles, Munthe-Kaas, Nørsett, Zanna, Acta Numerica 9 (2000), §4, right instead of
 * left multiplication), by powers of h:
 *   θ = hΩ + h²Ω̇/2 + h³(Ω̈/6 + Ω×Ω̇/12) + h⁴(Ω⃛ + Ω×Ω̈)/24.
 * Conserves L, not E.
 */
class Buss4 {
 public:
  static constexpr Work kWork = {4, 1};  ///< of a step

  explicit Buss4(const Eigen::Vector3d& moments) : inverse_(moments.cwiseInverse()), euler_(moments) {}

  void step(FreeRotationState& state, double h) const {
    const Eigen::Vector3d& p = state.momentum_principal;
    const Eigen::Vector3d w((h * inverse_[0]) * p[0], (h * inverse_[1]) * p[1], (h * inverse_[2]) * p[2]);
    const Eigen::Vector3d w1 = euler_(w, w), w2 = 2 * euler_(w, w1), w3 = 2 * (euler_(w1, w1) + euler_(w, w2));
    rotate(state, w + 0.5 * w1 + ((1.0 / 6) * w2 + (1.0 / 24) * w3) + w.cross((1.0 / 12) * w1 + (1.0 / 24) * w2));
  }

 private:
  Eigen::Vector3d inverse_;
  EulerBracket euler_;
};

}  // namespace poinsot::steppers
