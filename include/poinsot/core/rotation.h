#pragma once

#include "poinsot/core/eigen_types.h"

/** SO(3): exp and log, as unit quaternions and as matrices. Angles in radians, rotation vectors θ = angle·axis. */
namespace poinsot {

/** hat(v)·w = v × w. */
inline Eigen::Matrix3d hat(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/** exp(θ) as a unit quaternion: (cos|θ|/2, sin(|θ|/2)/|θ| · θ). θ finite; |θ|² may underflow and overflow. */
Quaternion expQuaternion(const Eigen::Vector3d& theta);

/** The rotation vector of a unit quaternion, |θ| ≤ π; accurate at zero and near π. q and −q give the same. */
Eigen::Vector3d logQuaternion(const Quaternion& q);

/** exp(hat(θ)) as a matrix (Rodrigues). */
Eigen::Matrix3d expMatrix(const Eigen::Vector3d& theta);

/** The rotation vector of a rotation matrix, |θ| ≤ π; accurate at zero and near π. */
Eigen::Vector3d logMatrix(const Eigen::Matrix3d& rotation);

/** The angle of the rotation that takes a to b [rad], in [0, π]; accurate for small angles, unlike an arccosine. */
double angleBetween(const Quaternion& a, const Quaternion& b);

/** max |RᵀR − 1|, how far a matrix is from a rotation. */
double orthogonalityError(const Eigen::Matrix3d& rotation);

}  // namespace poinsot
