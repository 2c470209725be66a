#pragma once

#include <algorithm>
#include <cmath>

#include "compensated_sum.h"
#include "poinsot/core/rotation_state.h"
#include "steppers/restore_momentum.h"

namespace poinsot::steppers {

/**
 * Undoes the drift of E by rounding since the last time, for methods that keep E: their implicit equation is solved to
 * roundoff only, an error of some 5e-21 a step, always of the same sign. It matters most near the unstable axis, which
 * a body leaves the sooner the farther it is from the separatrix. There the distance 2E/|L|² − 1/μᵢ is tiny, and
 * rounding of E is a large part of it.
 *
 * That distance is a sum over the other two axes, Σ nⱼ²(1/μⱼ − 1/μᵢ) with n = Λ/|L|, which loses no digits near axis i;
 * of the three axes the one that loses least is taken. Λ is moved along the gradient of E on the sphere of |L|.
 */
class EnergyKeeper {
 public:
  explicit EnergyKeeper(const Eigen::Vector3d& moments) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        difference_[i][j] = (moments[i] - moments[j]) / moments[i] / moments[j];
        spread_ = std::max(spread_, std::abs(difference_[i][j]));
      }
    }
  }

  /** Returns 2E/|L|² − 1/μᵢ for i = 0, 1, 2. */
  Eigen::Vector3d gaps(const FreeRotationState& state) const {
    Eigen::Vector3d out;
    for (int i = 0; i < 3; ++i) out[i] = gap(state, i).value;
    return out;
  }

  /** Brings E back to the state's kept_energy_gaps. */
  void restore(FreeRotationState& state) const {
    Gap least = gap(state, 0);
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
      const Gap now = gap(state, i);
      if (now.size < least.size) least = now, axis = i;
    }
    restoreAt(state, axis, least.value);
  }

 private:
  struct Gap {
    double value;
    double size;  ///< the sum of the magnitudes: rounding is relative to it
  };

  Gap gap(const FreeRotationState& state, int i) const {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double* const p = state.momentum_principal.data();
    const double a = p[j] * p[j] * state.kept_inverse_square * difference_[i][j];
    const double b = p[k] * p[k] * state.kept_inverse_square * difference_[i][k];
    return {a + b, std::abs(a) + std::abs(b)};
  }

  void restoreAt(FreeRotationState& state, int i, double value) const {
    double* const p = state.momentum_principal.data();
    double* const rest = state.momentum_rest.data();
    double d[3], slope = 0;
    for (int j = 0; j < 3; ++j) {
      d[j] = difference_[i][j] - value;  // 1/μⱼ − 2E/|L|²
      slope += p[j] * p[j] * state.kept_inverse_square * (d[j] * d[j]);
    }
    if (!(slope > kLeastSlope * spread_ * spread_)) return;  // on the axis
    const double by = 0.5 * (state.kept_energy_gaps[i] - value) / slope;
    const double size = std::sqrt(slope) * std::abs(by);
    if (!(size <= kMostRestored)) return;  // more than rounding can do
    for (int j = 0; j < 3; ++j) addCompensated(p[j], rest[j], by * d[j] * p[j]);
  }

  static constexpr double kLeastSlope = 1e-300;
  double difference_[3][3];  ///< 1/μⱼ − 1/μᵢ
  double spread_ = 0;
};

}  // namespace poinsot::steppers
