#pragma once

#include "poinsot/core/eigen_types.h"

/** SO(3): exp and log, as unit quaternions and as matrices. Angles in radians, rotation vectors θ = angle·axis. */
namespace poinsot {

/** Returns the matrix with hat(v)·w = v × w. */
inline Eigen::Matrix3d hat(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/** Returns exp(θ) as a unit quaternion, (cos|θ|/2, sin(|θ|/2)/|θ| · θ), for any finite θ. */
Quaternion expQuaternion(const Eigen::Vector3d& theta);

/** Returns the rotation vector of a unit quaternion, |θ| ≤ π; accurate at zero and near π. q and −q give the same. */
Eigen::Vector3d logQuaternion(const Quaternion& q);

/** Returns exp(hat(θ)) as a matrix. */
Eigen::Matrix3d expMatrix(const Eigen::Vector3d& theta);

/** Returns the rotation vector of a rotation matrix, |θ| ≤ π; accurate at zero and near π. */
Eigen::Vector3d logMatrix(const Eigen::Matrix3d& rotation);

/** Returns the angle of the rotation from a to b [rad], in [0, π]; accurate for small angles too. */
double angleBetween(const Quaternion& a, const Quaternion& b);

/** Returns max |RᵀR − 1|, how far a matrix is from a rotation. */
double orthogonalityError(const Eigen::Matrix3d& rotation);

}  // namespace poinsot
