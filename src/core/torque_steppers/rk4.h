#pragma once

#include "compensated_sum.h"
#include "steppers/move_attitude.h"
#include "torque_steppers/torque_stepper.h"

namespace poinsot::torque_steppers {

/** The classical Runge–Kutta method (Kutta 1901) on (q, Λ, σ), as steppers/rk4.h, which is for free bodies. Takes every
 * torque. */
class Rk4 final : public TorqueStepper {
 public:
  using TorqueStepper::TorqueStepper;

 protected:
  Work step(RotationState& state, double t, double h, const Torques::Constant& constant) const override {
    const Point start{state.attitude.coeffs(), state.momentum_principal, state.slug_omega};
    const Point k1 = derivative(start, t, constant);
    const Point k2 = derivative(start.moved(0.5 * h, k1), t + 0.5 * h, constant);
    const Point k3 = derivative(start.moved(0.5 * h, k2), t + 0.5 * h, constant);
    const Point k4 = derivative(start.moved(h, k3), t + h, constant);
    const double sixth = h / 6.0;
    Eigen::Vector4d q = start.attitude;
    steppers::moveAttitude(q, state.attitude_rest,
                           sixth * (k1.attitude + 2.0 * (k2.attitude + k3.attitude) + k4.attitude));
    state.attitude.coeffs() = q;
    addCompensated<Eigen::Vector3d>(state.momentum_principal, state.momentum_rest,
                                    sixth * (k1.momentum + 2.0 * (k2.momentum + k3.momentum) + k4.momentum));
    if (torques().slug()) {
      addCompensated<Eigen::Vector3d>(state.slug_omega, state.slug_rest,
                                      sixth * (k1.slug + 2.0 * (k2.slug + k3.slug) + k4.slug));
    }
    return {4, 0, 4};
  }

 private:
  struct Point {
    Eigen::Vector4d attitude;  ///< x, y, z, w; between stages not quite unit
    Eigen::Vector3d momentum, slug;

    Point moved(double h, const Point& rate) const {
      return {attitude + h * rate.attitude, momentum + h * rate.momentum, slug + h * rate.slug};
    }
  };

  Point derivative(const Point& p, double t, const Torques::Constant& constant) const {
    const Eigen::Vector3d omega = p.momentum.cwiseQuotient(torques().moments());
    const Eigen::Quaterniond q(p.attitude);
    const Eigen::Vector3d torque = torques().at(t, constant, q.normalized(), omega, p.slug);
    Point out;
    out.attitude = (q * Eigen::Quaterniond(0, 0.5 * omega[0], 0.5 * omega[1], 0.5 * omega[2])).coeffs();
    out.momentum = p.momentum.cross(omega) + torque;
    out.slug = torques().slugAcceleration(omega, p.slug);
    return out;
  }
};

}  // namespace poinsot::torque_steppers
