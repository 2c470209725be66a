#include "poinsot/core/closed_form.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "closed_form/levels.h"
#include "closed_form/wide.h"
#include "poinsot/core/inertia.h"
#include "poinsot/core/number_text.h"
#include "poinsot/core/pi.h"
#include "refuse.h"

namespace poinsot {
namespace {

using closed_form::Constants;
using closed_form::Phases;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

closed_form::Start checked(const Eigen::Vector3d& moments, const Quaternion& q, const Eigen::Vector3d& omega) {
  PrincipalInertia::fromMoments(moments);
  requireFinite(omega);
  if (!q.coeffs().allFinite() || q.coeffs().isZero(0)) refuseAttitude(q);
  return {{moments[0], moments[1], moments[2]}, {omega[0], omega[1], omega[2]}, {q.w(), q.x(), q.y(), q.z()}};
}

void checkTime(const char* name, double t) {
  if (!std::isfinite(t)) refuse(std::string(name) + ": expected a finite number (s), got " + numberText(t, 17));
}

}  // namespace

ClosedForm::ClosedForm(const Eigen::Vector3d& moments, const Quaternion& attitude,
                       const Eigen::Vector3d& omega_principal)
    : moments_(moments), attitude_(attitude), omega_principal_(omega_principal) {
  const closed_form::Start start = checked(moments, attitude, omega_principal);
  if (closed_form::isOrdinary(start)) {
    closed_form::bestLevel().set_up(start, constants_);
  } else {
    closed_form::setUpWide(start, constants_);
  }
}

closed_form::Start ClosedForm::start() const {
  return checked(moments_, attitude_, omega_principal_);
}

ClosedForm::State ClosedForm::at(double t) const {
  State state;
  if (!closed_form::bestLevel().at(constants_, t, state.attitude.coeffs().data(), state.omega_principal.data())) {
    checkTime("t", t);
    Phases phases;
    closed_form::phasesWide(start(), constants_, t, phases);
    closed_form::bestLevel().at_phases(constants_, phases, state.attitude.coeffs().data(),
                                       state.omega_principal.data());
  }
  return state;
}

void ClosedForm::sample(double t0, double dt, std::int64_t n, double* const columns[7]) const {
  if (closed_form::bestLevel().sample(constants_, t0, dt, n, columns)) return;
  checkTime("t0", t0);
  checkTime("dt", dt);
  closed_form::sampleWide(start(), constants_, t0, dt, n, columns);
}

ClosedForm::Regime ClosedForm::regime() const {
  return constants_.kind == Constants::Kind::steady     ? Regime::steady
         : constants_.kind == Constants::Kind::periodic ? Regime::general
                                                        : Regime::separatrix;
}

int ClosedForm::encircledAxis() const {
  return constants_.encircled;
}

double ClosedForm::separatrixDistance() const {
  return constants_.complementary_modulus;
}

double ClosedForm::fromScaledTime(double t) const {
  return t / constants_.time_scale;
}

double ClosedForm::period() const {
  if (constants_.kind != Constants::Kind::periodic) return kInfinity;
  return fromScaledTime(2 / std::abs(constants_.rate.half.high));
}

double ClosedForm::timeToNextFlip(double t) const {
  checkTime("t", t);
  if (constants_.kind == Constants::Kind::steady || constants_.symmetric) return kInfinity;
  Phases phases;
  if (!closed_form::bestLevel().phases(constants_, t, phases)) {
    closed_form::phasesWide(start(), constants_, t, phases);
  }
  const double rate = constants_.rate.half.high;
  // Half-periods since Ω₂ last vanished, in the direction of time; the low part decides when the high one is whole.
  const double direction = rate < 0 ? -1 : 1;
  const double high = direction * phases.half.high, low = direction * phases.half.low;
  if (constants_.kind == Constants::Kind::separatrix) {
    const bool passed = high > 0 || (high == 0 && low >= 0);
    return passed ? kInfinity : fromScaledTime(-(high + low) / std::abs(rate));
  }
  const double whole = std::floor(high);
  double left = (1 - (high - whole)) - low;
  if (left > 1) left -= 1;
  if (!(left > 0)) left += 1;
  return fromScaledTime(left / std::abs(rate));
}

double ClosedForm::montgomeryAngle() const {
  if (constants_.kind != Constants::Kind::periodic) return std::numeric_limits<double>::quiet_NaN();
  return 8 * kPi * (constants_.rate.turn.high / std::abs(constants_.rate.half.high));
}

double ClosedForm::precessionRate() const {
  return 4 * kPi * constants_.rate.turn.high * constants_.time_scale;
}

}  // namespace poinsot
