#pragma once

#include <string>
#include <vector>

#include "poinsot/core/motion.h"

/** A tumbling body and each effect on it, for tests of effects. */
namespace poinsot {

inline MotionSetup torquedBody(const std::vector<Effect>& effects, const std::string& method = "taylor16",
                               double step = 0.05) {
  MotionSetup setup;
  setup.inertia = PrincipalInertia::fromMoments({1, 1.7, 2.1});
  setup.attitude = Eigen::Quaterniond(0.5, -0.1, 0.7, 0.3);
  setup.omega_body = {0.6, -0.5, 0.7};
  setup.method = method;
  setup.step = step;
  setup.effects = effects;
  return setup;
}

struct NamedEffects {
  const char* name;
  std::vector<Effect> effects;
  bool damped = false;
};

/** Each effect once, of the strength of the body's own motion times `strength`, and all of them together. */
inline std::vector<NamedEffects> eachEffect(double strength = 1) {
  const Effect body = ConstantTorque{Axes::body, {0.3 * strength, -0.2 * strength, 0.4 * strength}};
  const Effect world = ConstantTorque{Axes::world, {0.2 * strength, 0.3 * strength, -0.4 * strength}};
  const Effect weight = GravityTorque{strength, {0, 0, -2}, {0.1, -0.2, 0.4}};
  const Effect gradient = GravityGradient{0.6 * std::sqrt(strength), {1, 2, 2}, {2, 1, -2}};
  const Effect drag = ViscousDamping{{0.1 * strength, 0.2 * strength, 0.15 * strength}};
  const Effect slug = InternalDissipation{0.3, 0.2 * strength};
  const Effect schedule = TorqueSchedule{{{0.3, 1.1, Axes::body, {0.5 * strength, 0.2 * strength, -0.3 * strength}},
                                          {1.9, 2.65, Axes::world, {-0.4 * strength, 0.1 * strength, 0.6 * strength}}}};
  return {{"constant_torque, body", {body}},
          {"constant_torque, world", {world}},
          {"gravity_torque", {weight}},
          {"gravity_gradient", {gradient}},
          {"torque_schedule", {schedule}},
          {"viscous_damping", {drag}, true},
          {"internal_dissipation", {slug}, true},
          {"all of them", {body, world, weight, gradient, schedule, drag, slug}, true}};
}

}  // namespace poinsot
