#include "poinsot/view/picture_bounds.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "poinsot/view/ellipsoids.h"

namespace poinsot::view {
namespace {

constexpr int kSamples = 600;
constexpr double kMostSteps = 1e5;

void extend(PictureBounds& reach, const Motion& motion, const MotionState& state) {
  const PrincipalInertia& inertia = motion.setup().inertia;
  reach.semi_axis =
      std::max(reach.semi_axis, longestSemiAxis(inertia.moments(), inertia.toPrincipal(state.omega_body)));
  reach.momentum = std::max(reach.momentum, state.momentum_world.stableNorm());
  reach.torque = std::max(reach.torque, externalTorque(motion, state).stableNorm());
  reach.omega_later = state.omega_body;
}

double horizonOf(const Motion& motion) {
  double horizon = kBoundsHorizon;
  if (const Torques* torques = motion.torques(); torques && !torques->switches().empty()) {
    horizon = std::max(horizon, torques->switches().back() + kBoundsSoon);
  }
  if (const auto& step = motion.setup().step) horizon = std::min(horizon, kMostSteps * *step);
  return horizon;
}

double clamped(double value, double soon) {
  return soon > 0 ? std::min(value, kMostGrowth * soon) : value;
}

}  // namespace

Eigen::Vector3d externalTorque(const Motion& motion, const MotionState& state) {
  const Torques* torques = motion.torques();
  if (!torques || !torques->slug()) return state.torque_world;
  return state.torque_world + state.attitude * (torques->slug()->damping * (state.omega_body - state.slug_omega));
}

PictureBounds pictureBoundsOf(Motion motion) {
  const double horizon = horizonOf(motion);
  PictureBounds reach, soon;
  try {
    for (int i = 0; i <= kSamples; ++i) {
      const double t = horizon * i / kSamples;
      extend(reach, motion, motion.at(t));
      if (t <= kBoundsSoon) soon = reach;
    }
  } catch (const std::runtime_error&) {  // the motion ends here
  }
  reach.semi_axis = clamped(reach.semi_axis, soon.semi_axis);
  reach.momentum = clamped(reach.momentum, soon.momentum);
  reach.torque = clamped(reach.torque, soon.torque);
  return reach;
}

}  // namespace poinsot::view
