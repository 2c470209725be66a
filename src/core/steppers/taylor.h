#pragma once

#include <Eigen/Core>

namespace poinsot::steppers {

/**
 * Euler's equations for t = hΩ in body axes: h²Ω̇ = t∘t with (a∘b)ᵢ = ½rᵢ(aⱼbₖ + aₖbⱼ), r₁ = (μ₂ − μ₃)/μ₁ and so on
 * round. Only ratios of the moments and angles occur: no scale of either is too large or too small.
 */
class EulerBracket {
 public:
  explicit EulerBracket(const Eigen::Vector3d& moments)
      : half_(0.5 * Eigen::Vector3d(moments[1] - moments[2], moments[2] - moments[0], moments[0] - moments[1])
                        .cwiseQuotient(moments)) {}

  Eigen::Vector3d operator()(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    return {half_[0] * (a[1] * b[2] + a[2] * b[1]), half_[1] * (a[2] * b[0] + a[0] * b[2]),
            half_[2] * (a[0] * b[1] + a[1] * b[0])};
  }

 private:
  Eigen::Vector3d half_;
};

}  // namespace poinsot::steppers
