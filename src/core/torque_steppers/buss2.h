#pragma once

#include "compensated_sum.h"
#include "steppers/rotate.h"
#include "torque_steppers/torque_stepper.h"

namespace poinsot::torque_steppers {

/**
 * Buss's augmented second-order method (J. Comput. Phys. 164 (2000) 377–406) with a torque: R ← exp(hω̃)R with
 *   ω̃ = ω + (h/2)α + (h²/12)(α × ω),   α = dω/dt = M_w⁻¹(τ − ω×L),
 * and L by the trapezoidal rule, its second torque from Ω and σ as Euler's rule foresees them. Second order; L changes
 * by the torques' impulse and nothing else. Takes every torque.
 */
class Buss2 final : public TorqueStepper {
 public:
  using TorqueStepper::TorqueStepper;

 protected:
  Work step(RotationState& state, double t, double h, const Torques::Constant& constant) const override {
    const Eigen::Vector3d& moments = torques().moments();
    const Eigen::Vector3d omega = state.omegaPrincipal(moments);
    const Eigen::Vector3d torque = torques().at(t, constant, state.attitude, omega, state.slug_omega);
    const Eigen::Vector3d slug_rate = torques().slugAcceleration(omega, state.slug_omega);
    const Eigen::Vector3d acceleration = (torque + state.momentum_principal.cross(omega)).cwiseQuotient(moments);

    addCompensated<Eigen::Vector3d>(state.momentum_principal, state.momentum_rest, (0.5 * h) * torque);
    steppers::rotate(state, h * omega + (0.5 * h * h) * acceleration + (h * h * h / 12) * acceleration.cross(omega));

    const Eigen::Vector3d foreseen = omega + h * acceleration, foreseen_slug = state.slug_omega + h * slug_rate;
    const Eigen::Vector3d second = torques().at(t + h, constant, state.attitude, foreseen, foreseen_slug);
    addCompensated<Eigen::Vector3d>(state.momentum_principal, state.momentum_rest, (0.5 * h) * second);
    if (torques().slug()) {
      const Eigen::Vector3d rate = slug_rate + torques().slugAcceleration(foreseen, foreseen_slug);
      addCompensated<Eigen::Vector3d>(state.slug_omega, state.slug_rest, (0.5 * h) * rate);
    }
    return {2, 1, 2};
  }
};

}  // namespace poinsot::torque_steppers
