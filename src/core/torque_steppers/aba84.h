#pragma once

#include "compensated_sum.h"
#include "kept_momentum.h"
#include "poinsot/core/method.h"
#include "torque_steppers/torque_stepper.h"

namespace poinsot::torque_steppers {

/**
 * Free motion and kicks in turn, exp(a₁A) exp(b₁B) exp(a₂A) … exp(a₁A), for torques that are weak beside the body's own
 * motion: with a torque of relative strength ε the error is O(εh⁸ + ε²h⁴). Coefficients: R. I. McLachlan, BIT 35 (1995)
 * 258–268, the pair (8, 4). Free motion is dmv8, of order 8, which keeps L and E; kicks are exact, Λ ← Λ + bhτ(t, R),
 * so that L changes by the torques' impulse and nothing else. Symplectic where the torque has a potential.
 *
 * Takes torques that depend on t and R alone: with damping, kicks would not be exact, and one of them runs backwards.
 */
class Aba84 final : public TorqueStepper {
 public:
  explicit Aba84(const Torques& given) : TorqueStepper(given), free_(findMethod("dmv8")->make(given.moments())) {}

 protected:
  Work step(RotationState& state, double t, double h, const Torques::Constant& constant) const override {
    RotationState rotation = state;  // dmv8 may throw
    Work work;
    double elapsed = 0;
    for (int i = 0; i < kKicks; ++i) {
      const double turn = kA[i < 3 ? i : 5 - i], kick = kB[i < 3 ? i : 4 - i];
      work += free_->advanceFrom(rotation, 0, turn * h);
      elapsed += turn * h;
      const Eigen::Vector3d torque =
          torques().at(t + elapsed, constant, rotation.attitude, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
      const Eigen::Vector3d impulse = (kick * h) * torque;
      addCompensated<Eigen::Vector3d>(rotation.momentum_principal, rotation.momentum_rest, impulse);
      inlined::keepMomentum(rotation, rotation.kept_momentum + rotation.attitude * impulse);
    }
    work += free_->advanceFrom(rotation, 0, kA[0] * h);
    state = rotation;
    work.torques = kKicks;
    return work;
  }

 private:
  static constexpr int kKicks = 5;
  static constexpr double kA1 = 0.07534696026989288842, kA2 = 0.5179168546882567823;
  static constexpr double kB1 = 0.19022593937367661925, kB2 = 0.84652407044352625706;
  static constexpr double kA[3] = {kA1, kA2, 0.5 - (kA1 + kA2)};
  static constexpr double kB[3] = {kB1, kB2, 1 - 2 * (kB1 + kB2)};

  std::unique_ptr<Stepper> free_;
};

}  // namespace poinsot::torque_steppers
