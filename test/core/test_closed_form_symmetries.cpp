// Bodies whose motions are the same but for a change of axes or units, exactly.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "comparisons.h"
#include "free_bodies.h"

namespace poinsot {
namespace {

// Two evaluations of the same, each within 2e-15.
constexpr double kTwice = 4e-15;

/** A rotation that takes principal axes to principal axes; its quaternion has whole components and is not unit. */
struct AxisRotation {
  Eigen::Matrix3d matrix;
  Eigen::Quaterniond quaternion;
};

/** All 24. */
std::vector<AxisRotation> axisRotations() {
  std::vector<AxisRotation> all;
  for (int w = -1; w <= 1; ++w) {
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          const Eigen::Quaterniond q(w, x, y, z);
          const double norm2 = q.squaredNorm();
          // 1, 2 and 4 have them: no turn, half and quarter turns, thirds. One of q and −q is enough.
          if (norm2 == 0 || norm2 == 3) continue;
          const Eigen::Vector4d c(w, x, y, z);
          if ((c[0] != 0 ? c[0] : c[1] != 0 ? c[1] : c[2] != 0 ? c[2] : c[3]) < 0) continue;
          all.push_back({q.normalized().toRotationMatrix().array().round(), q});
        }
      }
    }
  }
  return all;
}

void expectSame(const ClosedForm::State& a, const ClosedForm::State& b) {
  const double attitude = angle(a.attitude, b.attitude),
               omega = relativeDifference(a.omega_principal, b.omega_principal);
  RC_LOG() << "attitude off by " << attitude << " rad, Omega by " << omega << std::endl;
  RC_ASSERT(attitude <= kTwice);
  RC_ASSERT(omega <= kTwice);
}

/** Components that a power of two takes nowhere near the end of the range, which would round them. */
bool allNormal(const Eigen::Vector3d& v) {
  for (int i = 0; i < 3; ++i) {
    if (v[i] != 0 && std::abs(v[i]) < 1e-250) return false;
  }
  return true;
}

TEST(ClosedFormSymmetries, thereAre24RotationsOfTheAxes) {
  const std::vector<AxisRotation> all = axisRotations();
  EXPECT_EQ(all.size(), 24u);
  for (const AxisRotation& r : all) {
    EXPECT_EQ(r.matrix * r.matrix.transpose(), Eigen::Matrix3d::Identity());
    EXPECT_NEAR(r.matrix.determinant(), 1, 1e-15);
  }
}

RC_GTEST_PROP(ClosedFormSymmetries, turnedBackItRunsBackwards, ()) {
  const FreeBody body = draw::bodyOfAnySize();
  FreeBody turned = body;
  turned.omega = -body.omega;
  const double t = draw::time(body, 1e9);
  RC_LOG() << body << "t = " << shown(t) << std::endl;
  ClosedForm::State state = turned.closedForm().at(t);
  state.omega_principal = -state.omega_principal;
  expectSame(body.closedForm().at(-t), state);
}

// With axes renamed by a rotation P: μ' = PμPᵀ, Ω' = PΩ, R' = RPᵀ. An improper P = −P' acts on Ω, which is an axial
// vector, like P'; that Ω with one component reversed, −P'Ω, is the motion of P'Ω run backwards.
RC_GTEST_PROP(ClosedFormSymmetries, axesMayComeInAnyOrderAndSign, ()) {
  static const std::vector<AxisRotation> all = axisRotations();
  const FreeBody body = draw::bodyOfAnySize();
  const AxisRotation& p = all[draw::integer(0, 23)];
  const double mirrored = draw::sign(), t = draw::time(body, 1e9);
  FreeBody other;
  for (int i = 0; i < 3; ++i) other.moments[i] = p.matrix.row(i).cwiseAbs().dot(body.moments);
  other.omega = mirrored * (p.matrix * body.omega);
  other.attitude = body.attitude * p.quaternion.conjugate();  // exact: few bits times small integers
  RC_LOG() << body << other << "t = " << shown(t) << std::endl;
  const ClosedForm::State here = body.closedForm().at(mirrored * t), there = other.closedForm().at(t);
  const double off =
      angle(here.attitude.cast<Real>() * p.quaternion.conjugate().cast<Real>(), there.attitude.cast<Real>());
  RC_LOG() << "attitude off by " << off << std::endl;
  RC_ASSERT(off <= kTwice);
  RC_ASSERT(relativeDifference(mirrored * (p.matrix * here.omega_principal), there.omega_principal) <= kTwice);
}

RC_GTEST_PROP(ClosedFormSymmetries, theUnitOfInertiaDoesNotMatter, ()) {
  const FreeBody body = draw::bodyOfAnySize();
  FreeBody scaled = body;
  scaled.moments = std::ldexp(1.0, draw::integer(-600, 600)) * body.moments;
  const double t = draw::time(body, 1e9);
  RC_LOG() << body << scaled << "t = " << shown(t) << std::endl;
  const ClosedForm::State a = body.closedForm().at(t), b = scaled.closedForm().at(t);
  RC_ASSERT(a.attitude.coeffs() == b.attitude.coeffs());
  RC_ASSERT(a.omega_principal == b.omega_principal);
}

RC_GTEST_PROP(ClosedFormSymmetries, theUnitOfTimeDoesNotMatter, ()) {
  const FreeBody body = draw::bodyOfAnySize();
  const double factor = std::ldexp(1.0, draw::integer(-300, 300));
  FreeBody scaled = body;
  scaled.omega = factor * body.omega;
  RC_PRE(allNormal(body.omega) && allNormal(scaled.omega));
  const double t = draw::time(body, 1e9);
  RC_LOG() << body << scaled << "t = " << shown(t) << std::endl;
  const ClosedForm::State a = body.closedForm().at(t), b = scaled.closedForm().at(t / factor);
  RC_ASSERT(a.attitude.coeffs() == b.attitude.coeffs());
  RC_ASSERT(a.omega_principal * factor == b.omega_principal);
}

/** To so many bits that its product with a small integer is exact. */
Eigen::Vector3d with42Bits(const Eigen::Vector3d& v) {
  Eigen::Vector3d out;
  for (int i = 0; i < 3; ++i) {
    int e = 0;
    const double m = std::frexp(v[i], &e);
    out[i] = std::ldexp(std::rint(std::ldexp(m, 42)), e - 42);
  }
  return out;
}

RC_GTEST_PROP(ClosedFormSymmetries, anyFactorOfInertiaOrTime, ()) {
  FreeBody body = draw::bodyOfAnySize();
  body.moments = with42Bits(body.moments);
  body.omega = with42Bits(body.omega);
  const double inertia = draw::integer(1, 1000), time = draw::integer(1, 1000);
  FreeBody scaled = body;
  scaled.moments *= inertia;
  scaled.omega *= time;
  double t = with42Bits({draw::time(body, 1e9), 1, 1})[0];
  RC_LOG() << body << scaled << "t = " << shown(t) << " / " << time << std::endl;
  ClosedForm::State state = body.closedForm().at(t * time);
  state.omega_principal *= time;
  expectSame(state, scaled.closedForm().at(t));
}

}  // namespace
}  // namespace poinsot
