#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

/** Comparisons in long double, whose own roundoff is negligible. */
namespace poinsot {

using Real = long double;
using Vector3 = Eigen::Matrix<Real, 3, 1>;
using RealVector4 = Eigen::Matrix<Real, 4, 1>;
using RealQuaternion = Eigen::Quaternion<Real>;

/** b or −b, whichever is nearer to a. */
inline RealVector4 alignedWith(const RealVector4& a, const RealVector4& b) {
  return a.dot(b) < 0 ? RealVector4(-b) : b;
}

/** Returns the angle of the rotation from a to b [rad]; lengths and signs do not matter. */
template <class A, class B>
double angle(const Eigen::QuaternionBase<A>& a, const Eigen::QuaternionBase<B>& b) {
  const RealVector4 p = a.coeffs().template cast<Real>().stableNormalized();
  const RealVector4 q = alignedWith(p, b.coeffs().template cast<Real>().stableNormalized());
  return static_cast<double>(4 * std::asin(std::min<Real>((p - q).norm() / 2, 1)));
}

/** |a − b|/|a|; 0 when they are equal, also where both are infinite or zero. */
inline double relativeDifference(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  if (a == b) return 0;
  const Vector3 p = a.cast<Real>(), q = b.cast<Real>();
  return static_cast<double>((p - q).stableNorm() / p.stableNorm());
}

}  // namespace poinsot
