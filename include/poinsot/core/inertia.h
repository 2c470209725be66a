#pragma once

#include <algorithm>
#include <array>

#include "poinsot/core/eigen_types.h"

namespace poinsot {

/**
 * The inertia of a rigid body: its principal moments and its principal axes.
 *
 * There are two sets of axes, both fixed in the body, with the origin at the centre of mass:
 * - body axes: those in which the caller gave the inertia;
 * - principal axes: those in which the tensor is diagonal.
 * An object is always valid: the factories throw std::invalid_argument with a message that says what was expected and
 * what was given.
 */
class PrincipalInertia {
 public:
  /**
   * Returns the inertia of a body whose body axes are principal axes: axes() is the identity and the order is kept.
   * @param moments [kg·m²], each positive and finite. Moments that no real body has are accepted; see
   *        satisfiesTriangleInequality().
   */
  static PrincipalInertia fromMoments(const Eigen::Vector3d& moments);

  /**
   * Returns the inertia of a full tensor. A diagonal tensor keeps its axes; otherwise moments() ascend and axes() is a
   * proper rotation. Moments have an error of about 1e-16 of the largest, so a tensor whose smallest moment is below
   * 1e-14 of the largest is refused.
   * @param tensor in body axes [kg·m²], symmetric to 1e-9 of its largest entry and positive definite.
   */
  static PrincipalInertia fromTensor(const Eigen::Matrix3d& tensor);

  /** Returns μ₁, μ₂, μ₃ [kg·m²] about the principal axes. */
  const Eigen::Vector3d& moments() const { return moments_; }

  /** Returns the rotation principal axes → body axes, unit: v_body = axes() * v_principal. */
  const Quaternion& axes() const { return axes_; }

  /** Returns the components in principal axes of a vector that is given in body axes; of any unit. */
  Eigen::Vector3d toPrincipal(const Eigen::Vector3d& in_body) const;

  /** Returns the components in body axes of a vector that is given in principal axes; of any unit. */
  Eigen::Vector3d toBody(const Eigen::Vector3d& in_principal) const;

  /** Returns M in body axes [kg·m²]. */
  Eigen::Matrix3d tensor() const;

  /** Returns whether μᵢ + μⱼ ≥ μₖ for all three (to roundoff), as for every distribution of positive mass. */
  bool satisfiesTriangleInequality() const;

 private:
  PrincipalInertia(const Eigen::Vector3d& moments, const Quaternion& axes) : moments_(moments), axes_(axes) {}

  Eigen::Vector3d moments_;
  Quaternion axes_;
};

/** Returns the axes of the smallest, the intermediate and the largest moment, each 0, 1 or 2. */
inline std::array<int, 3> ascendingAxes(const Eigen::Vector3d& moments) {
  std::array<int, 3> axes{0, 1, 2};
  std::sort(axes.begin(), axes.end(), [&](int i, int j) { return moments[i] < moments[j]; });
  return axes;
}

}  // namespace poinsot
