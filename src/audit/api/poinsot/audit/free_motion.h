#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>

/** The audit's own physics of a free body, in body axes (any, not only principal ones). Shares no code with the node's.
 */
namespace poinsot::audit {

/** exp of a rotation vector [rad]. */
Eigen::Quaterniond rotationBy(const Eigen::Vector3d& theta);

/** The rotation vector [rad] of a unit quaternion, |θ| ≤ π. */
Eigen::Vector3d rotationVector(const Eigen::Quaterniond& q);

struct Inertia {
  explicit Inertia(const Eigen::Matrix3d& tensor);

  Eigen::Matrix3d tensor, inverse;
  Eigen::Vector3d moments;  ///< ascending

  double energy(const Eigen::Vector3d& omega_body) const { return 0.5 * omega_body.dot(tensor * omega_body); }
  /** |L|/μ_min: no motion of that momentum turns faster [rad/s]. */
  double fastestRate(const Eigen::Vector3d& omega_body) const { return (tensor * omega_body).norm() / moments[0]; }
  /** How fast two neighbouring motions can part: exponentially near the unstable axis [1/s]. */
  double partingRate(const Eigen::Vector3d& omega_body) const;
  /** What rounding Ω and M once does to E and to L, relatively: 1 for a sphere, up to about μ_max/μ_min. */
  double conditionOfEnergy(const Eigen::Vector3d& omega_body) const;
  double conditionOfMomentum(const Eigen::Vector3d& omega_body) const;
};

struct FreeState {
  Eigen::Quaterniond attitude;  ///< body → world, unit
  Eigen::Vector3d omega_body;   ///< [rad/s]
};

/**
 * Euler's equations and the attitude over `duration` [s, either sign], by the classical Runge–Kutta method in substeps
 * of at most 0.005 rad at the fastest rate. Local error per substep below (0.005)⁵/30, see `freeMotionError`. Nothing
 * where more than 50 000 substeps would be needed.
 */
std::optional<FreeState> freeMotion(const Inertia& inertia, const FreeState& start, double duration);

/** What `freeMotion` and the rounding of its start may be off by at the end [rad, and Ω relative to the fastest rate].
 */
double freeMotionError(const Inertia& inertia, const Eigen::Vector3d& omega_body, double duration);

}  // namespace poinsot::audit
