#pragma once

#include <Eigen/Core>

#include "poinsot/core/motion.h"

namespace poinsot::view {

/**
 * The torque on a body as a whole [N·m], world axes: dL/dt of the L in `state`. What a slug inside exerts on the body
 * around it is not in it.
 */
Eigen::Vector3d externalTorque(const Motion& motion, const MotionState& state);

/** How large the picture of a body under torques gets. */
struct PictureBounds {
  double semi_axis = 0;                                   ///< the longest of the two ellipsoids', |MΩ|/μmin [rad/s]
  double momentum = 0;                                    ///< |L| [kg·m²/s]
  double torque = 0;                                      ///< |externalTorque| [N·m]
  Eigen::Vector3d omega_later = Eigen::Vector3d::Zero();  ///< Ω at the end [rad/s], body axes
};

constexpr double kBoundsHorizon = 60;  ///< s
constexpr double kBoundsSoon = 10;     ///< s
constexpr double kMostGrowth = 2;      ///< see pictureBoundsOf

/**
 * The largest values for 0 ≤ t ≤ 60 s, or 10 s beyond the last switch of a schedule; for less where that takes more
 * than 1e5 steps, or where the motion ends before.
 *
 * What is spun up for long would be too small to see at first: no value is more than kMostGrowth times the largest of
 * the first 10 s, unless that is zero.
 */
PictureBounds pictureBoundsOf(Motion motion);

}  // namespace poinsot::view
