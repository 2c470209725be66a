// Properties of the free motion of every body: it is a flow, it conserves E and L, it is
// continuous, and grids are single evaluations.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "comparisons.h"
#include "free_bodies.h"
#include "slow_property.h"

namespace poinsot {
namespace {

// The error of an evaluation: rad for the attitude, relative to |Ω| for Ω.
constexpr double kAccuracy = 2e-15;

struct Difference {
  double attitude = 0;  ///< rad
  double omega = 0;     ///< of |Ω|
};

Difference difference(const ClosedForm::State& a, const ClosedForm::State& b) {
  return {angle(a.attitude, b.attitude), relativeDifference(a.omega_principal, b.omega_principal)};
}

/**
 * A motion taken up from its state at t, and how far rounding that state to doubles may lead astray: an evaluation may
 * be off by kAccuracy, so Ω lies somewhere in a box of ±kAccuracy·|Ω| about what it should be. Moving to the faces of
 * that box changes the later state by so much; to first order, going to its worst corner adds the three changes up.
 * The closed form takes its inputs for exact, so such differences show in full down to its own accuracy.
 */
class TakenUp {
 public:
  TakenUp(const FreeBody& body, double t) : body_(body), start_(body.closedForm().at(t)) {}

  ClosedForm::State at(double s) const { return from(start_.omega_principal).at(s); }

  /** Returns the effect of the box after s. */
  Difference uncertainty(double s) const {
    Difference sum;
    for (int i = 0; i < 3; ++i) {
      const Difference here = response(i, 1, s);
      sum.attitude += here.attitude;
      sum.omega += here.omega;
    }
    return sum;
  }

  /**
   * Whether first order tells the truth: a box eight times as large does eight times as much. Near the unstable axis it
   * does not, once what rounding did has outgrown the distance from the axis, and then all bets are off.
   */
  bool isLinear(double s) const {
    for (int i = 0; i < 3; ++i) {
      const Difference small = response(i, 1, s), large = response(i, 8, s);
      if (!grows(small.attitude, large.attitude) || !grows(small.omega, large.omega)) return false;
    }
    return true;
  }

 private:
  static bool grows(double small, double large) {
    return large < 1e-13 || (large < 1e-3 && 6 * small < large && large < 10 * small);
  }

  /** The change after s when component i of Ω moves to the farther one of two faces of a box `size` times as large. */
  Difference response(int i, double size, double s) const {
    const ClosedForm::State centre = at(s);
    const Eigen::Vector3d step = size * kAccuracy * start_.omega_principal.stableNorm() * Eigen::Vector3d::Unit(i);
    const Difference up = difference(centre, from(start_.omega_principal + step).at(s));
    const Difference down = difference(centre, from(start_.omega_principal - step).at(s));
    return {std::max(up.attitude, down.attitude), std::max(up.omega, down.omega)};
  }

  ClosedForm from(const Eigen::Vector3d& omega) const { return {body_.moments, start_.attitude, omega}; }

  FreeBody body_;
  ClosedForm::State start_;
};

/** Three evaluations take part: the one compared with, the one taken up from and the one after it. */
void expectNear(const ClosedForm::State& wanted, const ClosedForm::State& got, const Difference& uncertainty) {
  const Difference off = difference(wanted, got);
  RC_LOG() << "attitude off by " << off.attitude << " rad, uncertain " << uncertainty.attitude << "; Omega off by "
           << off.omega << ", uncertain " << uncertainty.omega << std::endl;
  RC_ASSERT(off.attitude <= 3 * kAccuracy + uncertainty.attitude);
  RC_ASSERT(off.omega <= 3 * kAccuracy + uncertainty.omega);
}

RC_GTEST_PROP(ClosedFormProperties, isAFlow, ()) {
  const FreeBody body = draw::bodyOfAnySize();
  const double t = draw::onGrid(body, draw::time(body, 5e8));
  const TakenUp taken_up(body, t);
  double s = draw::onGrid(body, draw::time(body, 1e3));
  while (!taken_up.isLinear(s)) s = draw::onGrid(body, s / 2);
  RC_LOG() << body << "t = " << shown(t) << ", s = " << shown(s) << std::endl;
  expectNear(body.closedForm().at(t + s), taken_up.at(s), taken_up.uncertainty(s));
}

RC_GTEST_PROP(ClosedFormProperties, goesBackTheWayItCame, ()) {
  const FreeBody body = draw::bodyOfAnySize();
  double t = draw::onGrid(body, draw::time(body, 1e6));
  while (!TakenUp(body, t).isLinear(-t)) t = draw::onGrid(body, t / 2);
  const TakenUp taken_up(body, t);
  RC_LOG() << body << "t = " << shown(t) << std::endl;
  expectNear({body.attitude, body.omega}, taken_up.at(-t), taken_up.uncertainty(-t));
}

RC_GTEST_PROP(ClosedFormProperties, isWhereItStarts, ()) {
  const FreeBody body = draw::bodyOfAnySize();
  RC_LOG() << body;
  const ClosedForm::State start = body.closedForm().at(0);
  RC_ASSERT(angle(body.attitude, start.attitude) <= kAccuracy);
  RC_ASSERT(relativeDifference(body.omega, start.omega_principal) <= kAccuracy);
}

RC_GTEST_PROP(ClosedFormProperties, keepsTheQuaternionUnit, ()) {
  const FreeBody body = draw::bodyOfAnySize();
  const double t = draw::time(body, 1e9);
  RC_LOG() << body << "t = " << shown(t) << std::endl;
  RC_ASSERT(std::abs(body.closedForm().at(t).attitude.cast<Real>().norm() - 1) <= 1e-15L);
}

// No weights for extreme ratios of the moments: the error of each component of Λ is one of its own amplitude, which is
// at most |L| and at most √(2Eμᵢ), so it moves neither E nor L by more than that.
RC_GTEST_PROP(ClosedFormProperties, conservesEnergyAndMomentum, ()) {
  const FreeBody body = draw::bodyOfAnySize();
  const double t = draw::time(body, 1e9);
  const ClosedForm::State state = body.closedForm().at(t);
  const Vector3 mu = body.moments.cast<Real>();
  const auto momentum = [&](const Eigen::Vector3d& omega) -> Vector3 { return mu.cwiseProduct(omega.cast<Real>()); };
  const auto twiceEnergy = [&](const Eigen::Vector3d& omega) -> Real {
    return momentum(omega).dot(omega.cast<Real>());
  };
  const Real e0 = twiceEnergy(body.omega), l0 = momentum(body.omega).norm();
  const Vector3 in_world_0 = body.attitude.cast<Real>().normalized() * momentum(body.omega);
  const Vector3 in_world = state.attitude.cast<Real>() * momentum(state.omega_principal);
  const double energy = static_cast<double>(std::abs(twiceEnergy(state.omega_principal) / e0 - 1));
  const double size = static_cast<double>(std::abs(momentum(state.omega_principal).norm() / l0 - 1));
  const double turn = static_cast<double>((in_world - in_world_0).norm() / l0);
  RC_LOG() << body << "t = " << shown(t) << ": E off by " << energy << ", |L| by " << size << ", L by " << turn
           << std::endl;
  RC_ASSERT(energy <= 1e-14);
  RC_ASSERT(size <= 1e-14);
  RC_ASSERT(turn <= 1e-14);
}

/** The fastest that anything may change: |Ωᵢ| ≤ wᵢ as E and |L| allow, and |Ω̇ᵢ| ≤ |μⱼ − μₖ|wⱼwₖ/μᵢ in units of wᵢ. */
Real fastestRate(const FreeBody& body) {
  const Vector3 mu = body.moments.cast<Real>(), momentum = mu.cwiseProduct(body.omega.cast<Real>());
  const Real l = momentum.norm(), twice_energy = momentum.dot(body.omega.cast<Real>());
  Vector3 w;
  for (int i = 0; i < 3; ++i) w[i] = std::min(l / mu[i], std::sqrt(twice_energy / mu[i]));
  Real fastest = w.maxCoeff();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    fastest = std::max(fastest, std::abs(mu[j] - mu[k]) * w[j] * w[k] / (mu[i] * w[i]));
  }
  return fastest;
}

// Euler's equations and q̇ = ½q(0, Ω), by central differences over ±h. With ν = fastestRate and νh ≤ 1e-4, what they
// leave out is some (νh)² and the roundoff of two evaluations 4e-15/(νh), of rates that are at most ν; 1e-6 is well
// above both.
RC_GTEST_PROP(ClosedFormProperties, obeysTheEquationsOfMotion, ()) {
  const FreeBody body = draw::bodyOfAnySize();
  const Real fastest = fastestRate(body);
  const double h = std::ldexp(1.0, static_cast<int>(std::floor(std::log2(1e-4L / fastest))));
  const double t = draw::time(body, 1e3);
  const double before_t = t - h, after_t = t + h;
  const Real between = static_cast<Real>(after_t) - before_t;
  RC_PRE(between > h);
  const ClosedForm form = body.closedForm();
  const ClosedForm::State before = form.at(before_t), here = form.at(t), after = form.at(after_t);
  const Vector3 mu = body.moments.cast<Real>(), omega = here.omega_principal.cast<Real>(),
                momentum = mu.cwiseProduct(omega);
  const Vector3 change = mu.cwiseProduct(after.omega_principal.cast<Real>() - before.omega_principal.cast<Real>());
  const RealQuaternion q = here.attitude.cast<Real>();
  const RealQuaternion rate = q * RealQuaternion(0, omega[0] / 2, omega[1] / 2, omega[2] / 2);
  const RealVector4 turn = after.attitude.cast<Real>().coeffs() - before.attitude.cast<Real>().coeffs();
  // The times need not lie evenly about t once they are rounded: first order remains.
  const Real middle = (static_cast<Real>(after_t) - t) - (static_cast<Real>(t) - before_t);
  const Real slack = 1e-6L + fastest * std::abs(middle);
  RC_LOG() << body << "t = " << shown(t) << ", h = " << shown(h) << std::endl;
  RC_ASSERT((change / between - momentum.cross(omega)).norm() <= slack * fastest * momentum.norm());
  RC_ASSERT((turn / between - rate.coeffs()).norm() <= slack * fastest);
}

// Each of the two is within 9e-16 rad of the truth (test_closed_form_rows); a grid carries its phases by products of
// two rotations, which adds up to 3e-16.
SLOW_PROPERTY(ClosedFormProperties, samplesAreSingleEvaluations) {
  const FreeBody body = draw::bodyOfAnySize();
  const int count = draw::oneOf({1, 2, 7, 8, 9, 20});
  // t₀ + j·dt is a double for every j, so that `at` can be asked for exactly that time.
  const double t0 = draw::onGrid(body, draw::time(body, 5e8)), dt = draw::onGrid(body, draw::time(body, 1e6));
  const ClosedForm form = body.closedForm();
  const ClosedForm::Samples table = form.sample(t0, dt, count);
  RC_ASSERT(table.rows() == count);
  double off = 0, omega_off = 0;
  for (int j = 0; j < count; ++j) {
    const ClosedForm::State state = form.at(t0 + j * dt);
    const Eigen::Quaterniond attitude(table(j, 0), table(j, 1), table(j, 2), table(j, 3));
    off = std::max(off, angle(state.attitude, attitude));
    omega_off = std::max(omega_off, relativeDifference(state.omega_principal, table.row(j).tail<3>().transpose()));
    RC_ASSERT(state.attitude.dot(attitude) > 0);
    RC_ASSERT(std::abs(attitude.cast<Real>().norm() - 1) <= 1e-15L);
  }
  RC_LOG() << body << "t0 = " << shown(t0) << ", dt = " << shown(dt) << ", " << count << " rows: attitude off by "
           << off << ", Omega by " << omega_off << std::endl;
  RC_ASSERT(off <= 1.2e-15);
  RC_ASSERT(omega_off <= 1.2e-15);
}

// The attitude turns by less than half a turn between the two times, so the quaternion must not change its sign.
RC_GTEST_PROP(ClosedFormProperties, theQuaternionIsContinuous, ()) {
  const FreeBody body = draw::body();
  const double most = body.moments.cwiseProduct(body.omega).norm() / body.moments.minCoeff();
  const ClosedForm form = body.closedForm();
  const double t = draw::time(body, 1e6), later = t + 1 / most;
  RC_LOG() << body << "t = " << shown(t) << " and " << shown(later) << std::endl;
  RC_ASSERT(form.at(t).attitude.dot(form.at(later).attitude) > 0.5);
}

}  // namespace
}  // namespace poinsot
