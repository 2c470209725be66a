// The motion of a body that names no method.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "draws.h"
#include "poinsot/core/method.h"
#include "poinsot/core/motion.h"
#include "poinsot/core/rotation.h"

namespace poinsot {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

const Vector3d kMoments(1, 2, 3);

MotionSetup wingnut() {
  MotionSetup setup;
  setup.inertia = PrincipalInertia::fromMoments(kMoments);
  setup.attitude = Quaterniond(0.5, -0.5, 0.5, 0.5);
  setup.omega_body = {0.01, 1, 0.02};
  return setup;
}

/** How far the norm is from 1; in long double, so that no rounding of the test's own is added. */
double farFromUnit(const Quaternion& q) {
  long double sum = 0;
  for (int i = 0; i < 4; ++i) sum += static_cast<long double>(q.coeffs()[i]) * static_cast<long double>(q.coeffs()[i]);
  return static_cast<double>(std::abs(std::sqrt(sum) - 1));
}

MotionSetup stepped(const char* method, double step) {
  MotionSetup setup = wingnut();
  setup.method = method;
  setup.step = step;
  return setup;
}

const double kTimes[] = {0, 5e-324, 1e-9, -0.3, 1, 20.5, -1234.5, 1e6, -1e9, 1e15, -1e100, 1e300, 1.7e308};

TEST(MotionInClosedForm, isTheDefault) {
  EXPECT_EQ(MotionSetup().method, "closed_form");
  EXPECT_FALSE(MotionSetup().step);
  EXPECT_TRUE(Motion(wingnut()).inClosedForm());
  EXPECT_TRUE(Motion(wingnut()).conservesMomentum());
  EXPECT_FALSE(Motion(stepped("rk4", 0.1)).inClosedForm());
}

TEST(MotionInClosedForm, isTheClosedFormInPrincipalAxes) {
  const ClosedForm form(kMoments, wingnut().attitude, wingnut().omega_body);
  Motion motion(wingnut());
  for (const double t : kTimes) {
    const ClosedForm::State expected = form.at(t);
    const MotionState state = motion.at(t);
    EXPECT_EQ(state.time, t);
    EXPECT_LE(angleBetween(state.attitude, expected.attitude), 1e-15) << t;
    EXPECT_EQ(state.omega_body, expected.omega_principal) << t;
  }
}

TEST(MotionInClosedForm, keepsWhatAFreeBodyKeepsAtAnyTime) {
  Motion motion(wingnut());
  const MotionState start = motion.at(0);
  EXPECT_LE(farFromUnit(start.attitude), 4e-16);
  EXPECT_LE((start.omega_body - wingnut().omega_body).norm(), 2e-16);
  for (const double t : kTimes) {
    const MotionState state = motion.at(t);
    EXPECT_LE(farFromUnit(state.attitude), 4e-16) << t;
    // From the state itself, so that roundoff shows.
    EXPECT_EQ(state.kinetic_energy, 0.5 * state.omega_body.dot(kMoments.cwiseProduct(state.omega_body))) << t;
    EXPECT_LE(std::abs(energyDrift(state.invariants(), start.invariants())), 4e-15) << t;
    EXPECT_LE(momentumDrift(state.invariants(), start.invariants()), 4e-15) << t;
  }
}

TEST(MotionInClosedForm, takesNoSteps) {
  Motion motion(wingnut());
  std::atomic<bool> cancel{true};
  for (const double t : kTimes) {
    EXPECT_EQ(motion.stepsTo(t), 0);
    EXPECT_TRUE(motion.prepare(t, cancel));
  }
  for (const double t : {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(motion.stepsTo(t), std::numeric_limits<double>::infinity());
    EXPECT_THROW(motion.at(t), std::out_of_range);
    EXPECT_THROW(motion.prepare(t, cancel), std::out_of_range);
  }
}

TEST(MotionInClosedForm, tensorInTurnedAxesIsTheSamePhysicalMotion) {
  Draws draws;
  for (int i = 0; i < 50; ++i) {
    // Body axes B are turned by S from the principal axes P: v_B = S v_P.
    const Quaterniond s = draws.attitude();
    const Eigen::Matrix3d turn = s.toRotationMatrix();
    MotionSetup principal = wingnut();
    principal.attitude = draws.attitude();
    principal.omega_body = draws.vector();
    MotionSetup turned = principal;
    turned.inertia = PrincipalInertia::fromTensor(turn * kMoments.asDiagonal() * turn.transpose());
    turned.attitude = principal.attitude * s.conjugate();
    turned.omega_body = s * principal.omega_body;
    Motion a(principal), b(turned);
    for (const double t : {0.0, 1.0, -4.2}) {
      const MotionState p = a.at(t), q = b.at(t);
      EXPECT_LE(angleBetween(p.attitude * s.conjugate(), q.attitude), 1e-13);
      EXPECT_LE((s * p.omega_body - q.omega_body).norm(), 1e-13);
      EXPECT_LE((p.omega_world - q.omega_world).norm(), 1e-13);
      EXPECT_LE((p.momentum_world - q.momentum_world).norm(), 1e-13);
      EXPECT_NEAR(q.attitude.norm(), 1, 4e-16);
      EXPECT_LE((q.attitude * q.omega_body - q.omega_world).norm(), 1e-14);
      EXPECT_LE((q.attitude * (turned.inertia.tensor() * q.omega_body) - q.momentum_world).norm(), 3e-14);
    }
    EXPECT_LE(angleBetween(turned.attitude, b.at(0).attitude), 2e-15);
  }
}

TEST(MotionInClosedForm, aPositionBeyondDoublesIsNotReturned) {
  MotionSetup setup = wingnut();
  setup.translation = Translation{{1, 2, 3}, {0, 0, 10}, {0, 0, -9.81}};
  Motion motion(setup);
  EXPECT_TRUE(motion.at(1e150).position.allFinite());
  EXPECT_THROW(motion.at(1e200), std::range_error);
  EXPECT_THROW(motion.at(-1e200), std::range_error);
}

TEST(AttitudeError, isTheAngleToTheClosedForm) {
  Motion exact(wingnut());
  for (const Method& method : freeMethods()) {
    Motion motion(stepped(method.name, 0.01));
    EXPECT_LE(motion.attitudeError(motion.at(0)), 1e-15);
    for (const double t : {0.004, 1.0, -7.77, 30.0}) {
      const MotionState state = motion.at(t);
      EXPECT_NEAR(motion.attitudeError(state), angleBetween(state.attitude, exact.at(t).attitude), 1e-15);
      if (method.order <= 3) {  // others may be right to the last bit
        EXPECT_GT(motion.attitudeError(state), 0);
      }
    }
  }
  EXPECT_EQ(exact.attitudeError(exact.at(17)), 0);
}

TEST(AttitudeError, fallsAsTheOrderSays) {
  for (const Method& method : freeMethods()) {
    // At halves of steps that are grid points of both.
    const double step = std::ldexp(1.0, method.order <= 2 ? -6 : method.order <= 4 ? -4 : -1);
    Motion coarse(stepped(method.name, step)), fine(stepped(method.name, step / 2));
    const double ratio = coarse.attitudeError(coarse.at(4)) / fine.attitudeError(fine.at(4));
    EXPECT_NEAR(std::log2(ratio), method.order, method.order <= 6 ? 0.2 : 0.4) << method.name;
  }
}

TEST(AttitudeError, isMeasuredInBodyAxesThatAreNotPrincipal) {
  Draws draws;
  const Eigen::Matrix3d turn = draws.attitude().toRotationMatrix();
  MotionSetup setup = stepped("rk4", 1e-3);
  setup.inertia = PrincipalInertia::fromTensor(turn * kMoments.asDiagonal() * turn.transpose());
  Motion motion(setup);
  setup.method = kClosedForm;
  setup.step.reset();
  Motion exact(setup);
  for (const double t : {0.0, 1.0, -3.0}) {
    const MotionState state = motion.at(t);
    EXPECT_NEAR(motion.attitudeError(state), angleBetween(state.attitude, exact.at(t).attitude), 2e-15);
    EXPECT_LE(motion.attitudeError(state), 1e-11);
  }
}

}  // namespace
}  // namespace poinsot
