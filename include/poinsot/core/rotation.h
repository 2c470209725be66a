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

/** exp(θ) in pieces: the unit quaternion (c, ½s·θ). */
struct HalfTurn {
  double c;  ///< cos(|θ|/2)
  double s;  ///< sin(|θ|/2) / (|θ|/2)
};

/** Beyond |θ| = 2, where steppers rarely go. θ that is not finite gives NaN. */
HalfTurn wideHalfTurn(const Eigen::Vector3d& theta);

/**
 * For any finite θ, also where |θ|² leaves the range of doubles.
 * Up to |θ| = 2 both functions are their Taylor series in z = |θ|²/4, which is where sin(x)/x would be 0/0 and where
 * steppers spend their time; summed in pairs, so that the processor need not wait for one term after the other.
 */
inline HalfTurn halfTurn(const Eigen::Vector3d& theta) {
  const double z = 0.25 * (theta[0] * theta[0] + theta[1] * theta[1] + theta[2] * theta[2]);
  const double z2 = z * z, z4 = z2 * z2;
  // First terms left out, |θ| < 1/8: z⁵/10! and z⁵/11!, below 3e-19.
  if (z < 0.00390625) {
    return {(1 - z * (1.0 / 2)) + z2 * ((1.0 / 24 - z * (1.0 / 720)) + z2 * (1.0 / 40320)),
            (1 - z * (1.0 / 6)) + z2 * ((1.0 / 120 - z * (1.0 / 5040)) + z2 * (1.0 / 362880))};
  }
  // |θ| < 1/2: z⁷/14! and z⁷/15!, below 5e-20.
  if (z < 0.0625) {
    return {((1 - z * (1.0 / 2)) + z2 * (1.0 / 24 - z * (1.0 / 720))) +
                z4 * ((1.0 / 40320 - z * (1.0 / 3628800)) + z2 * (1.0 / 479001600)),
            ((1 - z * (1.0 / 6)) + z2 * (1.0 / 120 - z * (1.0 / 5040))) +
                z4 * ((1.0 / 362880 - z * (1.0 / 39916800)) + z2 * (1.0 / 6227020800))};
  }
  // |θ| < 2: z¹⁰/20! and z⁹/19!, below 1e-17. The 1 is added last, so that little is lost to rounding.
  if (z < 1) {
    const double z8 = z4 * z4;
    return {1 + ((z2 * (1.0 / 24 - z * (1.0 / 720)) - z * (1.0 / 2)) +
                 (z4 * ((1.0 / 40320 - z * (1.0 / 3628800)) + z2 * (1.0 / 479001600 - z * (1.0 / 87178291200))) +
                  z8 * (1.0 / 20922789888000 - z * (1.0 / 6402373705728000)))),
            1 + ((z2 * (1.0 / 120 - z * (1.0 / 5040)) - z * (1.0 / 6)) +
                 (z4 * ((1.0 / 362880 - z * (1.0 / 39916800)) + z2 * (1.0 / 6227020800 - z * (1.0 / 1307674368000))) +
                  z8 * (1.0 / 355687428096000)))};
  }
  return wideHalfTurn(theta);
}

/** exp(θ) as a unit quaternion: (cos|θ|/2, sin(|θ|/2)/|θ| · θ). θ finite; |θ|² may underflow and overflow. */
inline Eigen::Quaterniond expQuaternion(const Eigen::Vector3d& theta) {
  const HalfTurn turn = halfTurn(theta);
  const double half = 0.5 * turn.s;
  return {turn.c, half * theta.x(), half * theta.y(), half * theta.z()};
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
