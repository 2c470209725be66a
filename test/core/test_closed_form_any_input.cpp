// No valid input gives a NaN or an exception: numbers of any exponent, denormals and zeros included.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "comparisons.h"
#include "free_bodies.h"
#include "slow_property.h"

namespace poinsot {
namespace {

/** Positive and finite, of any binary exponent or of one near the ends of the range. */
double anyPositive() {
  const int exponent = draw::integer(0, 2) == 0 ? draw::oneOf({-1074, -1073, -1060, -1022, -1, 0, 1, 1000, 1023})
                                                : draw::integer(-1074, 1023);
  const double x = std::ldexp(draw::uniform(1, 2), exponent);
  return std::max(x, std::numeric_limits<double>::denorm_min());
}

double anyNumber() {
  return draw::integer(0, 4) == 0 ? 0 : draw::sign() * anyPositive();
}

FreeBody anyBody() {
  FreeBody body;
  body.moments = {anyPositive(), anyPositive(), anyPositive()};
  if (draw::integer(0, 3) == 0) body.moments[1] = body.moments[0];
  body.omega = {anyNumber(), anyNumber(), anyNumber()};
  do {
    body.attitude = Eigen::Quaterniond(anyNumber(), anyNumber(), anyNumber(), anyNumber());
  } while (body.attitude.coeffs().isZero(0));
  return body;
}

/** Returns the bound of |Ωᵢ| at all times that follows from E and |L|. */
Real bound(const FreeBody& body, int i) {
  Real momentum = 0, twice_energy = 0;
  for (int k = 0; k < 3; ++k) {
    const Real mu = body.moments[k], w = body.omega[k];
    momentum = std::hypot(momentum, mu * w);
    twice_energy += mu * w * w;
  }
  const Real mu = body.moments[i];
  return std::min(momentum / mu, std::sqrt(twice_energy / mu));
}

void expectSound(const FreeBody& body, const Eigen::Vector4d& attitude, const Eigen::Vector3d& omega) {
  RC_ASSERT(std::abs(attitude.cast<Real>().norm() - 1) <= 1e-15L);
  for (int i = 0; i < 3; ++i) {
    RC_ASSERT(!std::isnan(omega[i]));
    const Real most = bound(body, i);
    if (std::isinf(omega[i])) {
      RC_ASSERT(most >= std::numeric_limits<double>::max());
    } else {
      RC_ASSERT(std::abs(omega[i]) <= most * (1 + 1e-14L) + std::numeric_limits<double>::denorm_min());
    }
  }
}

SLOW_PROPERTY(ClosedFormAnyInput, givesASoundState) {
  const FreeBody body = anyBody();
  const double t = anyNumber();
  RC_LOG() << body << "t = " << shown(t) << std::endl;
  const ClosedForm form = body.closedForm();
  const ClosedForm::State state = form.at(t);
  expectSound(body, state.attitude.coeffs(), state.omega_principal);
}

SLOW_PROPERTY(ClosedFormAnyInput, givesSoundGrids) {
  const FreeBody body = anyBody();
  const double t0 = anyNumber(), dt = anyNumber();
  RC_LOG() << body << "t0 = " << shown(t0) << ", dt = " << shown(dt) << std::endl;
  const ClosedForm::Samples table = body.closedForm().sample(t0, dt, 3);
  for (int j = 0; j < 3; ++j) {
    expectSound(body, table.row(j).head<4>().transpose(), table.row(j).tail<3>().transpose());
  }
}

SLOW_PROPERTY(ClosedFormAnyInput, givesSoundByProducts) {
  const FreeBody body = anyBody();
  const double t = anyNumber();
  RC_LOG() << body << "t = " << shown(t) << std::endl;
  const ClosedForm form = body.closedForm();
  const bool general = form.regime() == ClosedForm::Regime::general;
  RC_ASSERT(form.encircledAxis() >= (general ? 0 : -1) && form.encircledAxis() <= 2);
  RC_ASSERT(form.separatrixDistance() >= 0 && form.separatrixDistance() <= 1);
  RC_ASSERT((general ? form.period() >= 0 : std::isinf(form.period())));
  RC_ASSERT(form.timeToNextFlip(t) >= 0);
  RC_ASSERT(std::isnan(form.montgomeryAngle()) == !general);
  RC_ASSERT(form.precessionRate() >= 0);
}

}  // namespace
}  // namespace poinsot
