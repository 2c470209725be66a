#pragma once

#include <Eigen/Core>
#include <optional>

#include "poinsot/core/motion.h"
#include "poinsot/ros/marker_factory.h"
#include "poinsot/ros/marker_tracker.h"
#include "poinsot/view/trail.h"

namespace poinsot::node {

/**
 * What shows a body's effects: the torque on it as an arrow from its origin, and once more at the tip of L, which moves
 * that way; its weight, with the pivot, the rod to its centre of mass, and the way that the far end of that rod's line
 * has gone in the world, where a top draws its loops; the way to the centre of its orbit.
 *
 * A body has what its effects call for: an effect that is absent, or that only moves momentum about inside, has none.
 */
class EffectMarkers {
 public:
  struct Sizes {
    double shape_radius;                 ///< of the body about its centre of mass [m]
    double reach;                        ///< of the body from its origin [m]
    double torque;                       ///< the largest to be expected [N·m]
    double metres_per_angular_momentum;  ///< of the picture in world axes
  };
  EffectMarkers(const MarkerFactory& factory, const Motion& motion, const Sizes& sizes);

  /** How far its arrows may reach from the body's origin, downwards [m]. */
  double depth() const;

  void appendStatic(visualization_msgs::MarkerArray& out) const;

  /** @param torque_world the external one [N·m]. */
  void appendMoving(const MotionState& state, const Eigen::Vector3d& torque_world, MarkerTracker& tracker,
                    visualization_msgs::MarkerArray& out);

  /** Forgets the way gone: nobody looked, or the motion jumped. */
  void clearWay() { way_.clear(); }

 private:
  void appendTorque(const MotionState& state, const Eigen::Vector3d& torque_world, MarkerTracker& tracker,
                    visualization_msgs::MarkerArray& out) const;
  void appendWay(const MotionState& state, MarkerTracker& tracker, visualization_msgs::MarkerArray& out);

  MarkerFactory factory_;
  Sizes sizes_;
  bool torque_ = false;  ///< some effect exerts one
  std::optional<GravityTorque> weight_;
  std::optional<Torques::Gradient> orbit_;
  view::Trail way_;  ///< of a heavy body's far end, world axes
};

}  // namespace poinsot::node
