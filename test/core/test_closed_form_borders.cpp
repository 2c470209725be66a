// Where one regime of the closed form meets another, the motion depends smoothly on its start: a body on the border
// lies midway between two bodies an equal step to either side, but for a part that is of
// second order in the step. No reference is needed, and the accuracy required is that of single evaluations.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "comparisons.h"
#include "free_bodies.h"
#include "slow_property.h"

namespace poinsot {
namespace {

struct Bend {
  double step = 0;  ///< what the step does: the larger one of both sides
  double bend = 0;  ///< how far the middle is off
};

/** Of a point and its two neighbours; angles in rad, as twice those between quaternions. */
template <class Vector>
void add(Bend& sum, const Vector& below, const Vector& middle, const Vector& above, Real unit) {
  const Vector left = below - middle, right = above - middle;
  sum.step = std::max(sum.step, static_cast<double>(std::max(left.norm(), right.norm()) / unit));
  sum.bend = std::max(sum.bend, static_cast<double>((left + right).norm() / unit));
}

Bend bend(const FreeBody& below, const FreeBody& middle, const FreeBody& above, double t) {
  const ClosedForm::State a = below.closedForm().at(t), b = middle.closedForm().at(t), c = above.closedForm().at(t);
  const RealVector4 q = b.attitude.cast<Real>().coeffs();
  Bend sum;
  add<RealVector4>(sum, alignedWith(q, a.attitude.cast<Real>().coeffs()), q,
                   alignedWith(q, c.attitude.cast<Real>().coeffs()), Real(0.5));
  add<Vector3>(sum, a.omega_principal.cast<Real>(), b.omega_principal.cast<Real>(), c.omega_principal.cast<Real>(),
               b.omega_principal.cast<Real>().norm());
  return sum;
}

/** The errors of four evaluations, each within 2e-15, and the part of second order. */
void expectSmooth(const FreeBody& below, const FreeBody& middle, const FreeBody& above, double t) {
  Bend seen = bend(below, middle, above, t);
  // Near the unstable axis a step grows exponentially with time: look while it is small.
  for (int n = 0; n < 60 && seen.step > 1e-8; ++n) {
    t /= 2;
    seen = bend(below, middle, above, t);
  }
  RC_LOG() << "below: " << below << std::endl
           << "on it: " << middle << std::endl
           << "above: " << above << std::endl
           << "t = " << shown(t) << ": the step moves the state by " << seen.step << ", bent by " << seen.bend
           << std::endl;
  RC_ASSERT(seen.bend <= 8e-15 + 100 * seen.step * seen.step);
}

double ulps(double x, int count) {
  return count * (std::nextafter(std::abs(x), INFINITY) - std::abs(x));
}

RC_GTEST_PROP(ClosedFormBorders, ofTheSeparatrix, ()) {
  const FreeBody middle = draw::bodyOnSeparatrix();
  RC_ASSERT(middle.closedForm().regime() == ClosedForm::Regime::separatrix);
  FreeBody below = middle, above = middle;
  const int i = draw::integer(0, 2), count = draw::integer(1, 4);
  double& (*const which)(FreeBody&, int) =
      draw::integer(0, 1) == 0 ? +[](FreeBody& b, int k) -> double& { return b.omega[k]; }
                               : +[](FreeBody& b, int k) -> double& { return b.moments[k]; };
  which(below, i) -= ulps(which(below, i), count);
  which(above, i) += ulps(which(above, i), count);
  expectSmooth(below, middle, above, draw::time(middle, 1e3));
}

RC_GTEST_PROP(ClosedFormBorders, ofEqualMoments, ()) {
  FreeBody middle = draw::body();
  const int i = draw::integer(0, 2), j = (i + 1) % 3, k = (i + 2) % 3;
  middle.moments[j] = middle.moments[i];
  if (draw::integer(0, 3) == 0) middle.moments[k] = middle.moments[i];
  FreeBody below = middle, above = middle;
  const double step = ulps(middle.moments[i], draw::integer(1, 4));
  below.moments[i] -= step;
  above.moments[i] += step;
  expectSmooth(below, middle, above, draw::time(middle, 1e4));
}

/**
 * A spin about a principal axis and one that differs from it by so much of its rate or, about an axis of greater
 * moment, by so much of its momentum.
 */
void expectSmoothAboutSteadySpin(double least, double most) {
  FreeBody middle = draw::body();
  const int axis = draw::integer(0, 2), i = (axis + draw::integer(1, 2)) % 3, other = 3 - axis - i;
  middle.omega = draw::sign() * draw::uniform(0.5, 1) * Eigen::Vector3d::Unit(axis);
  RC_ASSERT(middle.closedForm().regime() == ClosedForm::Regime::steady);
  FreeBody below = middle, above = middle;
  const double step = draw::powerOfTen(least, most), share = draw::oneOf({0.0, 1.0, -1.0, 0.3});
  for (const auto& [k, size] : {std::make_pair(i, step), std::make_pair(other, share * step)}) {
    above.omega[k] = size * std::min(1.0, middle.moments[axis] / middle.moments[k]);
    below.omega[k] = -above.omega[k];
  }
  expectSmooth(below, middle, above, draw::time(middle, 1e3));
}

RC_GTEST_PROP(ClosedFormBorders, ofSteadySpins, ()) {
  expectSmoothAboutSteadySpin(-140, -9);
}

SLOW_PROPERTY(ClosedFormBorders, ofSteadySpinsVeryNear) {
  expectSmoothAboutSteadySpin(-320, -140);
}

RC_GTEST_PROP(ClosedFormBorders, ofRest, ()) {
  FreeBody middle = draw::body();
  const Eigen::Vector3d step = draw::powerOfTen(-30, -9) * middle.omega;
  FreeBody below = middle, above = middle;
  below.omega = -step;
  above.omega = step;
  middle.omega.setZero();
  const double t = draw::sign() * draw::powerOfTen(-3, 0);
  const ClosedForm::State a = below.closedForm().at(t), b = middle.closedForm().at(t), c = above.closedForm().at(t);
  RC_ASSERT(b.omega_principal.isZero(0));
  const RealVector4 q = b.attitude.cast<Real>().coeffs();
  Bend seen;
  add<RealVector4>(seen, alignedWith(q, a.attitude.cast<Real>().coeffs()), q,
                   alignedWith(q, c.attitude.cast<Real>().coeffs()), Real(0.5));
  RC_LOG() << above << "t = " << shown(t) << ": step " << seen.step << ", bend " << seen.bend << std::endl;
  RC_ASSERT(seen.bend <= 8e-15 + 100 * seen.step * seen.step);
}

// Both kinds of series converge everywhere, so where they meet is a matter of taste: at nome 0.2 or so. Between the
// separatrix and a spin about the axis that is gone round, k' goes from 0 to 1: the bodies tried are those about some
// k' near there, and among them are neighbours to either side of the border.
RC_GTEST_PROP(ClosedFormBorders, betweenTheSeries, ()) {
  FreeBody middle;
  const double m1 = draw::uniform(0.2, 1), m2 = m1 * draw::uniform(1.01, 3), m3 = m2 * draw::uniform(1.01, 3);
  middle.moments = {m1, m2, m3};
  middle.attitude = draw::attitude();
  const double slope = std::sqrt(m1 * (m2 - m1) / (m3 * (m3 - m2)));
  middle.omega = {draw::sign(), draw::uniform(-1, 1), draw::sign() * slope};
  const int axis = draw::oneOf({0, 2});
  const double wanted = draw::uniform(0.15, 0.35), on_separatrix = middle.omega[axis];
  double low = 1, high = 1e6;  // of on_separatrix
  while (std::nextafter(low, high) < high) {
    const double factor = (low + high) / 2;
    middle.omega[axis] = factor * on_separatrix;
    (middle.closedForm().separatrixDistance() < wanted ? low : high) = factor;
  }
  RC_ASSERT(std::abs(middle.closedForm().separatrixDistance() - wanted) <= 1e-13);
  FreeBody below = middle, above = middle;
  const double step = ulps(middle.omega[axis], draw::integer(1, 4));
  below.omega[axis] -= step;
  above.omega[axis] += step;
  expectSmooth(below, middle, above, draw::time(middle, 1e3));
}

}  // namespace
}  // namespace poinsot
