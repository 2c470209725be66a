#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/core/motion.h"
#include "poinsot/scene/scene.h"

/** A body of a scene with something changed, held to what a scene file is held to. Each throws Error with what is
 * allowed. */
namespace poinsot::scene {

/** Names of the methods that can move the body: the closed form first where there is one. */
std::vector<std::string> methodsFor(const Body& body);

/**
 * The body under a method of that name.
 * @param step [s], positive and finite; nothing: one at which the body turns by about 0.02 rad, less where the method
 *        needs it. Ignored by the closed form.
 * @param warnings gets a sentence where the step is doubtful.
 */
Body withMethod(Body body, const std::string& method, std::optional<double> step, std::vector<std::string>& warnings);

/**
 * The body starting anew at t = 0 where it is now, with this Ω [rad/s, body axes]; finite, and such that E and |L|² are
 * held in full precision. A step that would not follow the body then is refused.
 * @param now the body's state.
 */
Body withSpin(Body body, const MotionState& now, const Eigen::Vector3d& omega_body);

/**
 * The body with the start that another scene's body of the same kind has. Where its present step would not follow that,
 * it gets that body's method back too.
 */
Body withStartOf(Body body, const Body& other);

}  // namespace poinsot::scene
