#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "poinsot/core/inertia.h"
#include "poinsot/core/work.h"
#include "steppers/rotate.h"

namespace poinsot::steppers {

/** Symmetric compositions exp(a₁A) exp(b₁B) exp(a₂A) … exp(a₁A). Coefficients are listed from the ends to the middle,
 * each once. */
struct Strang {
  static constexpr int kOrder = 2;
  static constexpr std::array<double, 1> kA = {0.5};
  static constexpr std::array<double, 1> kB = {1.0};  ///< the middle one is a B
};

/** S₆ of order 4: S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313–330, table 2. The middle one is an A. */
struct BlanesMoan4 {
  static constexpr int kOrder = 4;
  static constexpr double a1 = 0.0792036964311957, a2 = 0.353172906049774, a3 = -0.0420650803577195;
  static constexpr double b1 = 0.209515106613362, b2 = -0.143851773179818;
  static constexpr std::array<double, 4> kA = {a1, a2, a3, 1 - 2 * (a1 + a2 + a3)};
  static constexpr std::array<double, 3> kB = {b1, b2, 0.5 - (b1 + b2)};
};

/** S₁₀ of order 6: the same source and table. The middle one is an A. */
struct BlanesMoan6 {
  static constexpr int kOrder = 6;
  static constexpr double a1 = 0.0502627644003922, a2 = 0.413514300428344, a3 = 0.0450798897943977,
                          a4 = -0.188054853819569, a5 = 0.541960678450780;
  static constexpr double b1 = 0.148816447901042, b2 = -0.132385865767784, b3 = 0.067307604692185,
                          b4 = 0.432666402578175;
  static constexpr std::array<double, 6> kA = {a1, a2, a3, a4, a5, 1 - 2 * (a1 + a2 + a3 + a4 + a5)};
  static constexpr std::array<double, 5> kB = {b1, b2, b3, b4, 0.5 - (b1 + b2 + b3 + b4)};
};

/**
 * Splitting into turns about two axes: with μ_b the intermediate moment,
 *   E = |Λ|²/2μ_b + ½(1/μ_a − 1/μ_b)Λ_a² + ½(1/μ_c − 1/μ_b)Λ_c².
 * The flow of the first term, a steady turn about L, commutes with the others and is applied once a step; the other two
 * are turns about axis a, which leave Λ_a alone, and about c (R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151–168;
 * F. Fassò, J. Comput. Phys. 189 (2003) 527–551). Composed symmetrically. Conserves L; symplectic, so that the error of
 * E stays bounded.
 */
template <class Composition>
class Splitting {
 public:
  /** The work of a step: no evaluation, one turn about L, and one for each coefficient of the composition. */
  static constexpr int kTurns = 2 * static_cast<int>(Composition::kA.size() + Composition::kB.size()) - 1;
  static constexpr Work kWork = {0, 1 + kTurns};

  /** The numbers that depend on the body and the step alone. */
  struct Plan {
    double half_a, half_c;  ///< half the angle of a turn over the whole step, for Λ = 1
    HalfTurn about_momentum;
    double rate;  ///< |θ|/|Λ| of the turn about L
  };

  explicit Splitting(const Eigen::Vector3d& moments) {
    axis_ = ascendingAxes(moments);
    const double a = moments[axis_[0]], b = moments[axis_[1]], c = moments[axis_[2]];
    rate_a_ = (b - a) / a / b;
    rate_c_ = -((c - b) / c / b);
    rate_ = 1 / b;
  }

  Plan plan(const FreeRotationState& state, double h) const {
    const double rate = h * rate_, angle = rate * state.kept_momentum.norm();
    return {0.5 * (h * rate_a_), 0.5 * (h * rate_c_), halfTurn({angle, 0, 0}), rate};
  }

  void step(FreeRotationState& state, const Plan& plan) const {
    // One turn about L, as seen from the body along Λ, which it does not move.
    const double* const p = state.momentum_principal.data();
    const Eigen::Vector3d theta(plan.rate * p[0], plan.rate * p[1], plan.rate * p[2]);
    turnAttitude(state, theta, plan.about_momentum);
    constexpr int na = Composition::kA.size(), nb = Composition::kB.size();
    for (int i = 0; i < nb; ++i) {
      turn(state, axis_[0], Composition::kA[i] * plan.half_a);
      turn(state, axis_[2], Composition::kB[i] * plan.half_c);
    }
    if (na > nb) turn(state, axis_[0], Composition::kA[na - 1] * plan.half_a);
    for (int i = na > nb ? nb - 1 : nb - 2; i >= 0; --i) {
      turn(state, axis_[2], Composition::kB[i] * plan.half_c);
      turn(state, axis_[0], Composition::kA[i] * plan.half_a);
    }
    if (na == nb) turn(state, axis_[0], Composition::kA[0] * plan.half_a);
    renormalise(state.attitude);
  }

 private:
  static void turnAttitude(FreeRotationState& state, const Eigen::Vector3d& theta, const HalfTurn& turn) {
    const double half = 0.5 * turn.s;
    const Eigen::Quaterniond by(turn.c, half * theta[0], half * theta[1], half * theta[2]);
    state.attitude = state.attitude * by;
  }

  /** The body turns about axis i by 2·rate·Λᵢ. */
  static void turn(FreeRotationState& state, int i, double rate) {
    static constexpr int kNext[] = {1, 2, 0};
    const int j = kNext[i], k = kNext[j];
    double* const p = state.momentum_principal.data();
    double* const rest = state.momentum_rest.data();
    const double half = rate * p[i];
    const HalfTurn t = halfTurn({2 * half, 0, 0});
    const double s = t.s * half, c = t.c;
    const double pj = p[j], pk = p[k], sine = 2 * s * c, versine = 2 * s * s;
    addCompensated(p[j], rest[j], sine * pk - versine * pj);
    addCompensated(p[k], rest[k], -sine * pj - versine * pk);
    double* const q = state.attitude.coeffs().data();  // x, y, z, w
    const double w = q[3], qi = q[i], qj = q[j], qk = q[k];
    q[3] = w * c - qi * s;
    q[i] = qi * c + w * s;
    q[j] = qj * c + qk * s;
    q[k] = qk * c - qj * s;
  }

  std::array<int, 3> axis_;  ///< of smallest, intermediate and largest moment
  double rate_a_, rate_c_, rate_;
};

using Splitting2 = Splitting<Strang>;
using Splitting4 = Splitting<BlanesMoan4>;
using Splitting6 = Splitting<BlanesMoan6>;

}  // namespace poinsot::steppers
