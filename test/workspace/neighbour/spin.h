#pragma once

#include <poinsot/BodyState.h>
#include <poinsot/core/motion.h>

/** A top about its own axis, where the motion is known: R(t) turns by |Ω| t. */
inline poinsot::BodyState spinOfTop(double t) {
  poinsot::MotionSetup setup;
  setup.inertia = poinsot::PrincipalInertia::fromMoments({1, 1, 2});
  setup.omega_body = {0, 0, 0.5};
  const poinsot::MotionState state = poinsot::Motion(setup).at(t);

  poinsot::BodyState message;
  message.body = "top";
  message.time = state.time;
  message.attitude.w = state.attitude.w();
  message.attitude.z = state.attitude.z();
  message.kinetic_energy = state.kinetic_energy;
  return message;
}
