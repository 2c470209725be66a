#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/core/motion.h"
#include "poinsot/scene/scene.h"

/**
 * Changes to a body of a scene. Each function returns the changed body, under the same conditions as a scene file, and
 * throws Error where it refuses the change.
 */
namespace poinsot::scene {

/** Returns the names of the methods that can move the body; the closed form comes first where there is one. */
std::vector<std::string> methodsFor(const Body& body);

/**
 * Returns the body under the method of that name.
 * @param step [s], positive and finite. Without one, the step is such that the body turns by about 0.02 rad in it, or
 *        less where the method needs that. The closed form ignores it.
 * @param warnings gets a sentence where the step is doubtful.
 */
Body withMethod(Body body, const std::string& method, std::optional<double> step, std::vector<std::string>& warnings);

/**
 * Returns the body starting anew at t = 0 from where it is now, with this Ω [rad/s, body axes]. Refuses an Ω that is
 * not finite or whose E or |L|² doubles do not hold in full precision, and a step that would not follow the body then.
 * @param now the body's state.
 */
Body withSpin(Body body, const MotionState& now, const Eigen::Vector3d& omega_body);

/**
 * Returns the body with the start of another scene's body of the same kind. Where its present step would not follow
 * that motion, it also gets that body's method.
 */
Body withStartOf(Body body, const Body& other);

}  // namespace poinsot::scene
