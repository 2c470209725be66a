#pragma once

#include <array>
#include <cstdint>

#include "contestant.h"

namespace poinsot::work_precision {

/** The state of general solvers of ordinary differential equations: w, x, y, z of the attitude, then Ω. */
using OdeState = std::array<double, 7>;

/** q̇ = ½q(0, Ω) and Euler's equations, with coefficients computed once, as a user would write them for speed. */
class FreeBodyEquations {
 public:
  explicit FreeBodyEquations(const Eigen::Vector3d& m)
      : a_((m[1] - m[2]) / m[0]), b_((m[2] - m[0]) / m[1]), c_((m[0] - m[1]) / m[2]) {}

  void operator()(const double* s, double* rate) const {
    rate[0] = 0.5 * (-s[1] * s[4] - s[2] * s[5] - s[3] * s[6]);
    rate[1] = 0.5 * (s[0] * s[4] + s[2] * s[6] - s[3] * s[5]);
    rate[2] = 0.5 * (s[0] * s[5] + s[3] * s[4] - s[1] * s[6]);
    rate[3] = 0.5 * (s[0] * s[6] + s[1] * s[5] - s[2] * s[4]);
    rate[4] = a_ * s[5] * s[6];
    rate[5] = b_ * s[6] * s[4];
    rate[6] = c_ * s[4] * s[5];
  }

 private:
  double a_, b_, c_;
};

inline OdeState odeStart(const Problem& p) {
  return {p.attitude.w(), p.attitude.x(), p.attitude.y(), p.attitude.z(), p.omega[0], p.omega[1], p.omega[2]};
}

inline Answer odeAnswer(double time, const double* s) {
  return {time, Eigen::Quaterniond(s[0], s[1], s[2], s[3]), Eigen::Vector3d(s[4], s[5], s[6])};
}

}  // namespace poinsot::work_precision
