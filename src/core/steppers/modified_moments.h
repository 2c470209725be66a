#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

#include "poinsot/core/inertia.h"

namespace poinsot::steppers {

/**
 * Returns the moments with which one step of the discrete Moser–Veselov map follows the free body to order 2n
 * (preprocessing: E. Hairer, G. Vilmart, J. Phys. A 39 (2006) 13225–13235), in the form |L|h/(2μ̃), for the three axes
 * in the order of `moments`. They depend on E, |L| and h alone, so that they are the same for a whole motion.
 *
 * The paper gives series in h² with polynomials in E and |L|². Here the coefficients are found as numbers. The map
 * moves along the polhode by the same phase from any start, so that one step determines them: the one that lies
 * symmetrically about the place, found on every orbit, where the component along the axis of intermediate moment is 0.
 * There Λ = (X, 0, Z): the flow from there, by Taylor's series, gives Λ(h/2) = (X f, X Z y, Z g) and, twice the turn
 * since, Gibbs' vector of the step, (e₁, 0, e₃); then μ̃₁ = (h/2)(1 + e²)X f/e₁, μ̃₃ = (h/2)(1 + e²)Z g/e₃, cut off after
 * n terms. 1/μ̃ is a/μ + b with the same a and b for all three, from which μ̃₂ follows.
 *
 * @param terms n ≥ 1; 1 gives the moments themselves.
 * @param inverse_inertia 2E/|L|².
 * @param half_angular |L|h/2.
 */
template <int terms>
Eigen::Vector3d modifiedInverses(const Eigen::Vector3d& moments, double inverse_inertia, double half_angular) {
  // Units: |L| = 1 and h/2 = 1.
  const Eigen::Vector3d inverse = moments.cwiseInverse(), b = half_angular * inverse;
  if constexpr (terms == 1) return b;
  const std::array<int, 3> axis = ascendingAxes(moments);
  const double m1 = moments[axis[0]], m2 = moments[axis[1]], m3 = moments[axis[2]];
  const double b1 = b[axis[0]], b2 = b[axis[1]], b3 = b[axis[2]];
  const double spread = (m3 - m1) / m1 / m3;
  const double x2 = spread == 0 ? 1 : std::max(0.0, std::min(1.0, (inverse_inertia - inverse[axis[2]]) / spread)),
               z2 = 1 - x2;
  const double weight = spread == 0 ? 0 : (m3 - m2) / m2 / m3 / spread;
  const double b12 = half_angular * ((m2 - m1) / m1 / m2), b23 = half_angular * ((m3 - m2) / m2 / m3), b13 = b12 + b23;

  // Even functions of time as Σ cₖ τᵏ, odd ones as t Σ cₖ τᵏ, τ = t².
  using Series = std::array<double, terms>;
  Series f{}, g{}, y{}, w{}, v1{}, v2{}, v3{};
  f[0] = g[0] = w[0] = 1;
  const auto product = [](const Series& a, const Series& c, int k) {
    double sum = 0;
    for (int i = 0; i <= k; ++i) sum += a[i] * c[k - i];
    return sum;
  };
  // The turn since, (w, X v₁, X Z v₂, Z v₃), and Λ = (X f, X Z y, Z g): y, v₁ and v₃ are odd, and v₂ begins with τ.
  for (int k = 0; k < terms; ++k) {
    const double odd = 1.0 / (2 * k + 1), even = 1.0 / (2 * k + 2);
    y[k] = odd * b13 * product(f, g, k);
    v1[k] = 0.5 * odd * (b1 * product(w, f, k) + z2 * (b3 * product(v2, g, k) - b2 * product(v3, y, k - 1)));
    v3[k] = 0.5 * odd * (b3 * product(w, g, k) - x2 * (b1 * product(v2, f, k) - b2 * product(v1, y, k - 1)));
    if (k + 1 == terms) break;
    f[k + 1] = -even * b23 * z2 * product(y, g, k);
    g[k + 1] = -even * b12 * x2 * product(f, y, k);
    w[k + 1] =
        -0.5 * even * (b1 * x2 * product(v1, f, k) + b2 * x2 * z2 * product(v2, y, k) + b3 * z2 * product(v3, g, k));
    v2[k + 1] = 0.5 * even * (b2 * product(w, y, k) + b1 * product(v3, f, k) - b3 * product(v1, g, k));
  }
  const auto at_half_step = [](const Series& series) {
    double sum = 0;
    for (int k = terms - 1; k >= 0; --k) sum += series[k];
    return sum;
  };
  const double F = at_half_step(f), G = at_half_step(g), W = at_half_step(w);
  const double V1 = at_half_step(v1), V2 = at_half_step(v2), V3 = at_half_step(v3);
  const double cosine = 1 - 2 * (x2 * V1 * V1 + z2 * V3 * V3);  // of half the angle of the step, 1/√(1 + e²)
  const double modified1 = 2 * cosine * (W * V1 - z2 * V2 * V3) / F;
  const double modified3 = 2 * cosine * (W * V3 + x2 * V1 * V2) / G;
  Eigen::Vector3d out;
  out[axis[0]] = modified1;
  out[axis[1]] = modified3 + weight * (modified1 - modified3);
  out[axis[2]] = modified3;
  return out;
}

}  // namespace poinsot::steppers
