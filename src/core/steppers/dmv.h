#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "poinsot/core/no_convergence.h"
#include "poinsot/core/work.h"
#include "steppers/modified_moments.h"
#include "steppers/rotate.h"

namespace poinsot::steppers {

/**
 * The discrete Moser–Veselov map (J. Moser, A. P. Veselov, Commun. Math. Phys. 139 (1991) 217–243), preprocessed to any
 * even order (E. Hairer, G. Vilmart, J. Phys. A 39 (2006) 13225–13235; see modified_moments.h). Conserves L and E;
 * symplectic and integrable: its orbit is the body's own polhode.
 *
 * In Gibbs' vector e of the step (tan of half the angle, along the axis, body axes) the map, Ω̃ᵀD − DΩ̃ = h hat(Λ) with
 * D = ½tr(M̃) − M̃, reads
 *   (h/2)(1 + e²)Λ = M̃e + e×M̃e.
 * With n = Λ/|L| and e = B g, B = |L|h/2 · M̃⁻¹, this is g + (Bg)×g = (1 + |Bg|²)n, in which nothing is large or small:
 * solved by Newton's method from the first terms of its series; throws NoConvergence.
 */
template <int order>
class Dmv {
 public:
  struct Plan {
    Eigen::Vector3d b;        ///< |L|h/(2μ̃)
    double inverse_momentum;  ///< 1/|L|, 0 at rest
  };

  explicit Dmv(const Eigen::Vector3d& moments) : moments_(moments) {}

  Plan plan(const FreeRotationState& state, double h) const {
    const double size = state.kept_momentum.norm();
    const double half_angular = 0.5 * h * size;
    return {modifiedInverses<order / 2>(moments_, state.kept_inverse_inertia, half_angular), size > 0 ? 1 / size : 0};
  }

  /** Of one step; the first terms of the series are two evaluations. */
  static constexpr Work work(int iterations) { return {iterations + 2, 1}; }

  /** @return iterations. */
  int step(FreeRotationState& state, const Plan& plan) const {
    const double* const p = state.momentum_principal.data();
    const double n0 = plan.inverse_momentum * p[0], n1 = plan.inverse_momentum * p[1],
                 n2 = plan.inverse_momentum * p[2];
    const double b0 = plan.b[0], b1 = plan.b[1], b2 = plan.b[2];
    const double b21 = b2 - b1, b02 = b0 - b2, b10 = b1 - b0;
    // g + (Bg)×g: the i-th component of the product is −(bₖ − bⱼ)gⱼgₖ.
    double g0 = n0 + b21 * (n1 * n2), g1 = n1 + b02 * (n2 * n0), g2 = n2 + b10 * (n0 * n1);
    {
      const double e0 = b0 * n0, e1 = b1 * n1, e2 = b2 * n2, square = e0 * e0 + e1 * e1 + e2 * e2;
      const double h0 = n0 + b21 * (g1 * g2) + square * n0, h1 = n1 + b02 * (g2 * g0) + square * n1,
                   h2 = n2 + b10 * (g0 * g1) + square * n2;
      g0 = h0, g1 = h1, g2 = h2;
    }
    for (int i = 0; i < kMostIterations; ++i) {
      const double e0 = b0 * g0, e1 = b1 * g1, e2 = b2 * g2, s = 1 + (e0 * e0 + e1 * e1 + e2 * e2);
      const double r0 = s * n0 - g0 + b21 * (g1 * g2), r1 = s * n1 - g1 + b02 * (g2 * g0),
                   r2 = s * n2 - g2 + b10 * (g0 * g1);
      // The derivative: 1 + off-diagonal products − 2n(B²g)ᵀ.
      const double t0 = 2 * b0 * e0, t1 = 2 * b1 * e1, t2 = 2 * b2 * e2;
      const double a00 = 1 - n0 * t0, a01 = -b21 * g2 - n0 * t1, a02 = -b21 * g1 - n0 * t2;
      const double a10 = -b02 * g2 - n1 * t0, a11 = 1 - n1 * t1, a12 = -b02 * g0 - n1 * t2;
      const double a20 = -b10 * g1 - n2 * t0, a21 = -b10 * g0 - n2 * t1, a22 = 1 - n2 * t2;
      const double c00 = a11 * a22 - a12 * a21, c01 = a12 * a20 - a10 * a22, c02 = a10 * a21 - a11 * a20;
      const double c10 = a02 * a21 - a01 * a22, c11 = a00 * a22 - a02 * a20, c12 = a01 * a20 - a00 * a21;
      const double c20 = a01 * a12 - a02 * a11, c21 = a02 * a10 - a00 * a12, c22 = a00 * a11 - a01 * a10;
      const double inverse = 1 / (a00 * c00 + a01 * c01 + a02 * c02);
      const double d0 = inverse * (c00 * r0 + c10 * r1 + c20 * r2), d1 = inverse * (c01 * r0 + c11 * r1 + c21 * r2),
                   d2 = inverse * (c02 * r0 + c12 * r1 + c22 * r2);
      g0 += d0, g1 += d1, g2 += d2;
      // Squared once more by convergence, that is below the last bit.
      if (d0 * d0 + d1 * d1 + d2 * d2 <= kSmallChange) {
        turn(state, b0 * g0, b1 * g1, b2 * g2);
        return i + 1;
      }
    }
    throw NoConvergence("dmv" + std::to_string(order));
  }

 private:
  static constexpr int kMostIterations = 20;
  static constexpr double kSmallChange = 1e-16;  // the square of a change of g, |g| being about 1

  static void turn(FreeRotationState& state, double e0, double e1, double e2) {
    const double cosine = 1 / std::sqrt(1 + (e0 * e0 + e1 * e1 + e2 * e2));
    rotate(state, {2 * e0, 2 * e1, 2 * e2}, {cosine, cosine});
  }

  Eigen::Vector3d moments_;
};

}  // namespace poinsot::steppers
