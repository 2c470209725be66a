// Periods, angles and rates that the closed form gives are those of the motion itself.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "comparisons.h"
#include "free_bodies.h"

namespace poinsot {
namespace {

constexpr double kAccuracy = 2e-15;
constexpr double kUlp = 2.3e-16;  // 2⁻⁵², relative

/** Ω̇ = M⁻¹(Λ × Ω). */
Eigen::Vector3d acceleration(const FreeBody& body, const Eigen::Vector3d& omega) {
  const Vector3 mu = body.moments.cast<Real>(), w = omega.cast<Real>();
  return mu.cwiseProduct(w).cross(w).cwiseQuotient(mu).cast<double>();
}

// A period rounded to a double is off by up to half an ulp; an ulp is allowed, and one for t + T. Ω and the attitude
// move on in that time.
struct Allowed {
  double attitude, omega;
};
Allowed allowed(const FreeBody& body, const Eigen::Vector3d& omega, double t) {
  const double late = kUlp * t;
  return {2 * kAccuracy + late * omega.norm(), 2 * kAccuracy + late * acceleration(body, omega).norm() / omega.norm()};
}

/** The axis of the middle moment. */
int middleAxis(const FreeBody& body) {
  int low = 0, high = 0;
  for (int i = 1; i < 3; ++i) {
    if (body.moments[i] < body.moments[low]) low = i;
    if (body.moments[i] >= body.moments[high]) high = i;
  }
  return 3 - low - high;
}

RC_GTEST_PROP(ClosedFormPeriods, omegaComesBack, ()) {
  const FreeBody body = draw::movingBody();
  const ClosedForm form = body.closedForm();
  const double period = form.period(), t = draw::integer(0, 1) == 0 ? 0 : draw::time(body, 1e3);
  const ClosedForm::State before = form.at(t), after = form.at(t + period);
  const Allowed most = allowed(body, before.omega_principal, std::abs(t) + period);
  const double off = relativeDifference(before.omega_principal, after.omega_principal);
  RC_LOG() << body << "T = " << period << ", t = " << t << ": off by " << off << " of " << most.omega << std::endl;
  RC_ASSERT(std::isfinite(period) && period > 0);
  RC_ASSERT(off <= most.omega);
}

// Not sooner: halfway, two components of Ω are reversed.
RC_GTEST_PROP(ClosedFormPeriods, halfwayTwoComponentsAreReversed, ()) {
  const FreeBody body = draw::movingBody();
  const ClosedForm form = body.closedForm();
  const double half = form.period() / 2;
  const Eigen::Vector3d after = form.at(half).omega_principal;
  Eigen::Vector3d wanted = -body.omega;
  wanted[form.encircledAxis()] *= -1;
  const double off = relativeDifference(wanted, after), most = allowed(body, wanted, half).omega;
  RC_LOG() << body << "T/2 = " << half << ": off by " << off << " of " << most << std::endl;
  RC_ASSERT(off <= most);
}

RC_GTEST_PROP(ClosedFormPeriods, aPeriodTurnsTheBodyAboutLByTheMontgomeryAngle, ()) {
  const FreeBody body = draw::movingBody();
  const ClosedForm form = body.closedForm();
  const double period = form.period(), turn = form.montgomeryAngle();
  const RealQuaternion start = body.attitude.cast<Real>().normalized();
  const Vector3 about = (start * body.moments.cwiseProduct(body.omega).cast<Real>()).normalized();
  const RealQuaternion wanted = RealQuaternion(Eigen::AngleAxis<Real>(turn, about)) * start;
  const double off = angle(wanted, form.at(period).attitude.cast<Real>());
  const double most = allowed(body, body.omega, period).attitude + kUlp * turn;
  RC_LOG() << body << "T = " << period << ", angle " << turn << ": off by " << off << " of " << most << std::endl;
  RC_ASSERT(turn > 0);
  RC_ASSERT(off <= most);
  RC_ASSERT(std::abs(form.precessionRate() * period / turn - 1) <= 4 * kUlp);
}

// 2E·T/|L| less the solid angle that L sweeps in body axes, the latter by the trapezoidal rule, which for a smooth
// periodic integrand converges faster than any power.
RC_GTEST_PROP(ClosedFormPeriods, theMontgomeryAngleIsTwoETOverLLessTheSolidAngle, ()) {
  const FreeBody body = draw::movingBody();
  const ClosedForm form = body.closedForm();
  const double ratio = body.moments.maxCoeff() / body.moments.minCoeff();
  RC_PRE(form.separatrixDistance() > 0.05 && ratio < 30);
  const int axis = form.encircledAxis(), i = (axis + 1) % 3, j = (axis + 2) % 3, count = 2000;
  const double side = body.omega[axis] < 0 ? -1 : 1;
  const ClosedForm::Samples table = form.sample(0, form.period() / count, count);
  const Vector3 mu = body.moments.cast<Real>();
  Real solid_angle = 0;
  for (int n = 0; n < count; ++n) {
    const Vector3 omega(table(n, 4), table(n, 5), table(n, 6));
    const Vector3 m = mu.cwiseProduct(omega).normalized(), rate = mu.cwiseProduct(omega).normalized().cross(omega);
    // (1 − cos θ) dφ = dφ sin²θ/(1 + cos θ), about the encircled axis.
    solid_angle += (m[i] * rate[j] - m[j] * rate[i]) / (1 + side * m[axis]);
  }
  solid_angle *= form.period() / static_cast<Real>(count);
  const Vector3 w = body.omega.cast<Real>(), l = mu.cwiseProduct(w);
  const Real wanted = l.dot(w) / l.norm() * form.period() - side * solid_angle;
  const double off = static_cast<double>(std::remainder(form.montgomeryAngle() - wanted, 2 * std::acos(Real(-1))));
  RC_LOG() << body << "angle " << form.montgomeryAngle() << ", wanted " << static_cast<double>(wanted) << ": off by "
           << off << std::endl;
  RC_ASSERT(std::abs(off) <= 1e-12 + 4 * kUlp * static_cast<double>(std::abs(wanted)));
}

RC_GTEST_PROP(ClosedFormPeriods, theEncircledAxisKeepsItsSignAndTheOthersChangeIt, ()) {
  const FreeBody body = draw::movingBody();
  const ClosedForm form = body.closedForm();
  const int axis = form.encircledAxis(), count = 64;
  const ClosedForm::Samples table = form.sample(draw::time(body, 1e3), form.period() / count, count);
  RC_LOG() << body << "axis " << axis << std::endl;
  for (int i = 0; i < 3; ++i) {
    const auto column = table.col(4 + i).array();
    const bool kept = (column >= 0).all() || (column <= 0).all();
    RC_ASSERT(kept == (i == axis));
  }
}

RC_GTEST_PROP(ClosedFormPeriods, flipsComeHalfAPeriodApart, ()) {
  const FreeBody body = draw::movingBody();
  const ClosedForm form = body.closedForm();
  const double t = draw::time(body, 1e3), period = form.period(), wait = form.timeToNextFlip(t);
  const int middle = middleAxis(body);
  RC_LOG() << body << "t = " << shown(t) << ", T = " << shown(period) << ", flip in " << wait << std::endl;
  const int other_1 = (middle + 1) % 3, other_2 = (middle + 2) % 3;
  const bool symmetric = body.moments[middle] == body.moments[other_1] || body.moments[middle] == body.moments[other_2];
  RC_ASSERT(std::isinf(wait) == symmetric);
  if (symmetric) return;
  RC_ASSERT(wait > 0 && wait <= period / 2 * (1 + 4 * kUlp));
  const ClosedForm::State flip = form.at(t + wait);
  // An ulp of the phase, which counts in half-periods, is one of the period.
  const double late = 2 * kUlp * (std::abs(t) + wait + period);
  RC_ASSERT(std::abs(flip.omega_principal[middle]) <=
            kAccuracy * flip.omega_principal.norm() +
                late * std::abs(acceleration(body, flip.omega_principal)[middle]));
  // No sign changes before it, one at it, and the next one is half a period later.
  const double before = form.at(t + 0.5 * wait).omega_principal[middle],
               after = form.at(t + wait + period / 4).omega_principal[middle];
  RC_ASSERT(before * after < 0);
  const double next = form.timeToNextFlip(t + wait + period / 4);
  RC_ASSERT(std::abs(next - period / 4) <= 8 * kUlp * (std::abs(t) + wait + period));
}

}  // namespace
}  // namespace poinsot
