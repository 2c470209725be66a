#pragma once

#include <array>
#include <cmath>

#include "poinsot/core/rotation_state.h"

namespace poinsot {

/**
 * An integrator that shares nothing with the library: MΩ̇ = MΩ × Ω and q̇ = ½q(0,Ω) by classical Runge–Kutta in long
 * double. With |Ω|h = 1/2048 its truncation is below 1e-14·|Ω|t/20.
 */
inline RotationState integrateFinely(const Eigen::Vector3d& moments, const RotationState& start, double t) {
  using Real = long double;
  using State = std::array<Real, 7>;  // w x y z, Ω
  const Real m1 = moments[0], m2 = moments[1], m3 = moments[2];
  const auto rate = [&](const State& s) -> State {
    const Real w = s[0], x = s[1], y = s[2], z = s[3], a = s[4], b = s[5], c = s[6];
    return {(-x * a - y * b - z * c) / 2, (w * a + y * c - z * b) / 2, (w * b + z * a - x * c) / 2,
            (w * c + x * b - y * a) / 2,  (m2 - m3) / m1 * b * c,      (m3 - m1) / m2 * c * a,
            (m1 - m2) / m3 * a * b};
  };
  const auto moved = [](const State& s, const State& d, Real h) {
    State out;
    for (int i = 0; i < 7; ++i) out[i] = s[i] + h * d[i];
    return out;
  };
  State s = {start.attitude.w(),
             start.attitude.x(),
             start.attitude.y(),
             start.attitude.z(),
             start.momentum_principal[0] / m1,
             start.momentum_principal[1] / m2,
             start.momentum_principal[2] / m3};
  const double fastest = start.momentum_principal.norm() / moments.minCoeff();
  const long steps = std::lround(std::ceil(std::abs(t) * fastest * 2048)) + 1;
  const Real h = static_cast<Real>(t) / steps;
  for (long n = 0; n < steps; ++n) {
    const State k1 = rate(s), k2 = rate(moved(s, k1, h / 2)), k3 = rate(moved(s, k2, h / 2)),
                k4 = rate(moved(s, k3, h));
    for (int i = 0; i < 7; ++i) s[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  RotationState out;
  out.attitude = Eigen::Quaterniond(static_cast<double>(s[0]), static_cast<double>(s[1]), static_cast<double>(s[2]),
                                    static_cast<double>(s[3]))
                     .normalized();
  out.momentum_principal = {static_cast<double>(s[4] * m1), static_cast<double>(s[5] * m2),
                            static_cast<double>(s[6] * m3)};
  return out;
}

}  // namespace poinsot
