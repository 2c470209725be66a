#pragma once

#include <Eigen/Core>

#include "poinsot/core/motion.h"

namespace poinsot::view {

/**
 * Returns the torque from outside [N·m], world axes: dL/dt of the L in `state`, without the torque of a slug on the
 * body around it.
 */
Eigen::Vector3d externalTorque(const Motion& motion, const MotionState& state);

/** The largest quantities in the picture of a body under torques. */
struct PictureBounds {
  double semi_axis = 0;                                   ///< longestSemiAxis() [rad/s]
  double momentum = 0;                                    ///< |L| [kg·m²/s]
  double torque = 0;                                      ///< |externalTorque| [N·m]
  Eigen::Vector3d omega_later = Eigen::Vector3d::Zero();  ///< Ω at the end [rad/s], body axes
};

// See pictureBoundsOf().
constexpr double kBoundsHorizon = 60;  ///< s
constexpr double kBoundsSoon = 10;     ///< s
constexpr double kMostGrowth = 2;

/**
 * Returns the largest values for 0 ≤ t ≤ kBoundsHorizon, or up to kBoundsSoon after the last switch of a schedule; for
 * less where that takes more than 1e5 steps, or where the motion ends before.
 *
 * No value is more than kMostGrowth times the largest of the first kBoundsSoon, unless that is zero: otherwise a body
 * that is spun up for long would be too small to see at first.
 */
PictureBounds pictureBoundsOf(Motion motion);

}  // namespace poinsot::view
