#pragma once

#include "../taylor/kernel.h"
#include "compensated_sum.h"
#include "steppers/move_attitude.h"
#include "torque_steppers/torque_stepper.h"

namespace poinsot::torque_steppers {

/**
 * Taylor's method: q, Ω, σ and the world vectors that the torques depend on, seen from the body, as power series in the
 * step, by recurrences (the right-hand sides are products of two at most); for example A. Jorba, M. Zou, Experimental
 * Mathematics 14 (2005) 99–117. Of any order, conserves nothing exactly, and everything to its truncation error. Takes
 * every torque.
 *
 * A step whose last two terms exceed 1e-6 of the state, and whose error is above 2e-5 by its terms, is halved, and the
 * halves likewise, until the last two terms of each are below 1e-6. So a step of a sensible length is taken whole, and
 * one that is too long for the motion is divided finely.
 */
template <int order>
class Taylor final : public TorqueStepper {
 public:
  explicit Taylor(const Torques& given) : TorqueStepper(given), kernel_(taylor::bestStep()) {
    for (int i = 0; i < 3; ++i) body_.moments[i] = torques().moments()[i];
    if (torques().hasWorldConstant()) setMap(Eigen::Matrix3d::Identity());
    for (const Torques::Field& field : torques().fields()) setMap(field.map);
    body_.gradient = torques().gradient().has_value();
    if (body_.gradient) body_.orbit_rate = torques().gradient()->rate;
    body_.damped = torques().damping().has_value();
    if (body_.damped) Eigen::Matrix3d::Map(body_.damping) = *torques().damping();
    body_.slug = torques().slug().has_value();
    if (body_.slug) {
      body_.slug_damping = torques().slug()->damping;
      body_.slug_rate = torques().slug()->damping / torques().slug()->inertia;
    }
  }

 protected:
  Work step(RotationState& state, double t, double h, const Torques::Constant& constant) const override {
    Work work;
    stepOrHalves(state, t, h, constant, kMostHalvings, work);
    return work;
  }

 private:
  static constexpr int kMostHalvings = 18;
  static constexpr double kMostError = 2e-5;      // of a whole step, of the state
  static constexpr double kMostLastTerms = 1e-6;  // of its parts

  void setMap(const Eigen::Matrix3d& map) { Eigen::Matrix3d::Map(body_.maps[body_.fields++]) = map; }

  void stepOrHalves(RotationState& state, double t, double h, const Torques::Constant& constant, int halvings,
                    Work& work) const {
    taylor::Increment increment;
    work += Work{order, 0, order};
    const taylor::LeftOut left_out = kernel_(body_, start(state, t, constant), order, h, increment);
    const bool is_whole = halvings == kMostHalvings;
    const bool is_small = left_out.last_terms <= kMostLastTerms || (is_whole && left_out.error <= kMostError);
    if (is_small) return add(increment, state);
    if (halvings > 0) {
      stepOrHalves(state, t, 0.5 * h, constant, halvings - 1, work);
      if (state.momentum_principal.allFinite()) {
        stepOrHalves(state, t + 0.5 * h, 0.5 * h, constant, halvings - 1, work);
      }
      return;
    }
    // The body moves faster than any step can follow, or is not finite: callers see a state of NaN.
    state.momentum_principal.setConstant(std::numeric_limits<double>::quiet_NaN());
  }

  taylor::Start start(const RotationState& state, double t, const Torques::Constant& constant) const {
    taylor::Start out;
    const Eigen::Quaterniond back = state.attitude.conjugate();
    const auto set = [](double* to, const Eigen::Vector3d& v) { Eigen::Vector3d::Map(to) = v; };
    Eigen::Vector4d::Map(out.attitude) = state.attitude.coeffs();
    set(out.omega, state.omegaPrincipal(torques().moments()));
    set(out.torque, constant.body);
    int i = 0;
    if (torques().hasWorldConstant()) set(out.fields[i++], back * constant.world);
    for (const Torques::Field& field : torques().fields()) set(out.fields[i++], back * field.world);
    if (body_.gradient) {
      set(out.radial, back * torques().gradient()->radialAt(t));
      set(out.along, back * torques().gradient()->alongAt(t));
    }
    if (body_.slug) set(out.slug_omega, state.slug_omega);
    return out;
  }

  void add(const taylor::Increment& increment, RotationState& state) const {
    Eigen::Vector4d q = state.attitude.coeffs();
    steppers::moveAttitude(q, state.attitude_rest, Eigen::Map<const Eigen::Vector4d>(increment.attitude));
    state.attitude.coeffs() = q;
    const Eigen::Map<const Eigen::Vector3d> omega(increment.omega), slug(increment.slug_omega);
    addCompensated<Eigen::Vector3d>(state.momentum_principal, state.momentum_rest,
                                    torques().moments().cwiseProduct(omega));
    if (body_.slug) addCompensated<Eigen::Vector3d>(state.slug_omega, state.slug_rest, slug);
  }

  taylor::Step kernel_;
  taylor::Body body_ = {};
};

}  // namespace poinsot::torque_steppers
