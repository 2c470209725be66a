#include "poinsot/view/ellipsoids.h"

#include <cmath>

namespace poinsot::view {

Eigen::Vector3d energySemiAxes(const Eigen::Vector3d& moments, double kinetic_energy) {
  // Roots before the quotient: 2E/μ may leave the range of doubles where its root does not.
  return (std::sqrt(2.0) * std::sqrt(kinetic_energy)) * moments.cwiseSqrt().cwiseInverse();
}

Eigen::Vector3d momentumSemiAxes(const Eigen::Vector3d& moments, double momentum_squared) {
  return std::sqrt(momentum_squared) * moments.cwiseInverse();
}

double longestSemiAxis(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal) {
  return moments.cwiseProduct(omega_principal).stableNorm() / moments.minCoeff();
}

}  // namespace poinsot::view
