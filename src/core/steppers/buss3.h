#pragma once

#include "poinsot/core/work.h"
#include "steppers/rotate.h"
#include "steppers/taylor.h"

namespace poinsot::steppers {

/**
 * Third order, one exponential a step: what Buss's augmented method (J. Comput. Phys. 164 (2000) 377–406) becomes with
 * the next term of Taylor's and Magnus' series (Iserles, Munthe-Kaas, Nørsett, Zanna, Acta Numerica 9 (2000), §4),
 *   θ = hΩ + h²Ω̇/2 + h³(Ω̈/6 + Ω×Ω̇/12) in body axes.
 * In world axes the bracket has the sign that Buss gives it, ω̇×ω/12, because ω̈ there is R(Ω̈ + Ω×Ω̇).
 * Conserves L, not E.
 */
class Buss3 {
 public:
  static constexpr Work kWork = {3, 1};  ///< of a step

  explicit Buss3(const Eigen::Vector3d& moments) : inverse_(moments.cwiseInverse()), euler_(moments) {}

  void step(FreeRotationState& state, double h) const {
    const Eigen::Vector3d& p = state.momentum_principal;
    const Eigen::Vector3d w((h * inverse_[0]) * p[0], (h * inverse_[1]) * p[1], (h * inverse_[2]) * p[2]);
    const Eigen::Vector3d w1 = euler_(w, w), w2 = 2 * euler_(w, w1);
    rotate(state, w + 0.5 * w1 + ((1.0 / 6) * w2 + (1.0 / 12) * w.cross(w1)));
  }

 private:
  Eigen::Vector3d inverse_;
  EulerBracket euler_;
};

}  // namespace poinsot::steppers
