#pragma once

#include <algorithm>
#include <array>

#include "poinsot/core/eigen_types.h"

namespace poinsot {

/**
 * The inertia of a rigid body: its principal moments and where its principal axes lie.
 *
 * Two sets of axes, both fixed in the body, origin at the centre of mass:
 * - body axes: those in which the caller gave the inertia;
 * - principal axes: those in which the tensor is diagonal.
 * Always valid: the factories throw std::invalid_argument with a message that names the value and what is allowed.
 */
class PrincipalInertia {
 public:
  /**
   * Body axes that are principal already; axes() is the identity and the order is kept.
   * @param moments kg·m², each positive and finite. Moments that no real body has (triangle inequality) are accepted:
   *        ask satisfiesTriangleInequality().
   */
  static PrincipalInertia fromMoments(const Eigen::Vector3d& moments);

  /**
   * A full tensor in body axes [kg·m²], symmetric to 1e-9 of its largest entry and positive definite.
   * A diagonal tensor keeps its axes; otherwise moments() ascend and axes() is a proper rotation. A moment is good to
   * about 1e-16 of the *largest* moment, so a tensor whose smallest is below 1e-14 of it is refused.
   */
  static PrincipalInertia fromTensor(const Eigen::Matrix3d& tensor);

  /** μ₁, μ₂, μ₃ [kg·m²] about the principal axes. */
  const Eigen::Vector3d& moments() const { return moments_; }

  /** Principal axes → body axes, unit: v_body = axes() * v_principal. */
  const Quaternion& axes() const { return axes_; }

  /** The components in principal axes of a vector that is given in body axes; of any unit. */
  Eigen::Vector3d toPrincipal(const Eigen::Vector3d& in_body) const;

  /** The components in body axes of a vector that is given in principal axes; of any unit. */
  Eigen::Vector3d toBody(const Eigen::Vector3d& in_principal) const;

  /** M in body axes [kg·m²]. */
  Eigen::Matrix3d tensor() const;

  /** True when μᵢ + μⱼ ≥ μₖ for all three (to roundoff), which every distribution of positive mass obeys. */
  bool satisfiesTriangleInequality() const;

 private:
  PrincipalInertia(const Eigen::Vector3d& moments, const Quaternion& axes) : moments_(moments), axes_(axes) {}

  Eigen::Vector3d moments_;
  Quaternion axes_;
};

/** The axes of the smallest, the intermediate and the largest moment, each 0, 1 or 2. */
inline std::array<int, 3> ascendingAxes(const Eigen::Vector3d& moments) {
  std::array<int, 3> axes{0, 1, 2};
  std::sort(axes.begin(), axes.end(), [&](int i, int j) { return moments[i] < moments[j]; });
  return axes;
}

}  // namespace poinsot
