#pragma once

#include "poinsot/core/motion.h"
#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/** Returns what core needs to move a body of a scene. */
inline MotionSetup motionSetup(const Body& body) {
  return {body.inertia, body.attitude, body.omega_body, body.method, body.step, body.translation, body.effects};
}

}  // namespace poinsot::scene
