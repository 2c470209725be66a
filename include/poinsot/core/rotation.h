#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

/** SO(3): exp and log, as unit quaternions and as matrices. Angles in radians, rotation vectors θ = angle·axis. */
namespace poinsot {

/** hat(v)·w = v × w. */
inline Eigen::Matrix3d hat(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/**
 * exp(θ) as a unit quaternion: (cos|θ|/2, sin(|θ|/2)/|θ| · θ).
 * Below |θ| = 1/2 both come from their Taylor series in |θ|²/4, which is where sin(x)/x would be 0/0 and where steppers
 * spend their time. θ finite; |θ|² may underflow, not overflow.
 */
inline Eigen::Quaterniond expQuaternion(const Eigen::Vector3d& theta) {
  const double x2 = 0.25 * theta.squaredNorm();  // (|θ|/2)²
  double c, s;                                   // cos x and (sin x)/x, x = |θ|/2
  if (x2 < 0.0625) {
    // First terms left out: x¹⁴/14! and x¹⁴/15!, below 5e-20.
    c = 1 + x2 * (-1.0 / 2 + x2 * (1.0 / 24 + x2 * (-1.0 / 720 + x2 * (1.0 / 40320 + x2 * (-1.0 / 3628800 +
                                                                                           x2 * (1.0 / 479001600))))));
    s = 1 + x2 * (-1.0 / 6 +
                  x2 * (1.0 / 120 +
                        x2 * (-1.0 / 5040 + x2 * (1.0 / 362880 + x2 * (-1.0 / 39916800 + x2 * (1.0 / 6227020800))))));
  } else {
    const double x = std::sqrt(x2);
    c = std::cos(x);
    s = std::sin(x) / x;
  }
  const double half = 0.5 * s;
  return {c, half * theta.x(), half * theta.y(), half * theta.z()};
}

/** The rotation vector of a unit quaternion, |θ| ≤ π; accurate at zero and near π. q and −q give the same. */
Eigen::Vector3d logQuaternion(const Eigen::Quaterniond& q);

/** exp(hat(θ)) as a matrix (Rodrigues). */
Eigen::Matrix3d expMatrix(const Eigen::Vector3d& theta);

/** The rotation vector of a rotation matrix, |θ| ≤ π; accurate at zero and near π. */
Eigen::Vector3d logMatrix(const Eigen::Matrix3d& rotation);

/** The angle of the rotation that takes a to b [rad], in [0, π]; accurate for small angles, unlike an arccosine. */
double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

/** max |RᵀR − 1|, how far a matrix is from a rotation. */
double orthogonalityError(const Eigen::Matrix3d& rotation);

/** One Newton step towards |q| = 1: enough, and cheap, for a quaternion that is unit to about 1e-8. */
inline void renormalise(Eigen::Quaterniond& q) {
  q.coeffs() *= 1.5 - 0.5 * q.squaredNorm();
}

}  // namespace poinsot
