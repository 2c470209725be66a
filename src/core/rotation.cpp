#include "poinsot/core/rotation.h"

#include <cmath>

#include "half_turn.h"

namespace poinsot {

HalfTurn wideHalfTurn(const Eigen::Vector3d& theta) {
  const double half = 0.5 * theta.stableNorm();
  return {std::cos(half), std::sin(half) / half};
}

Quaternion expQuaternion(const Eigen::Vector3d& theta) {
  const HalfTurn turn = halfTurn(theta);
  const double half = 0.5 * turn.s;
  return {turn.c, half * theta.x(), half * theta.y(), half * theta.z()};
}

Eigen::Vector3d logQuaternion(const Quaternion& q) {
  const double sign = q.w() < 0 ? -1.0 : 1.0;
  const double w = sign * q.w();
  const Eigen::Vector3d v = sign * q.vec();
  const double n = v.stableNorm();
  // 2 atan(n/w)/n → 2/w at zero; there n² is below roundoff.
  if (n < 1e-9) return (2.0 / w) * v;
  return (2.0 * std::atan2(n, w) / n) * v;
}

Eigen::Matrix3d expMatrix(const Eigen::Vector3d& theta) {
  return expQuaternion(theta).toRotationMatrix();
}

Eigen::Vector3d logMatrix(const Eigen::Matrix3d& rotation) {
  // Eigen's conversion starts from the largest of the four components (Shepperd), so nothing is lost near π.
  return logQuaternion(Eigen::Quaterniond(rotation).normalized());
}

double angleBetween(const Quaternion& a, const Quaternion& b) {
  const Eigen::Quaterniond d = a.conjugate() * b;
  return 2.0 * std::atan2(d.vec().stableNorm(), std::abs(d.w()));
}

double orthogonalityError(const Eigen::Matrix3d& rotation) {
  return (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
}

}  // namespace poinsot
