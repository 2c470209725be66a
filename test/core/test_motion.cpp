#include "poinsot/core/method.h"
#include "poinsot/core/motion.h"

#include <gtest/gtest.h>

#include <limits>

#include "draws.h"
#include "poinsot/core/rotation.h"

namespace poinsot {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

MotionSetup wingnut(const char* method = "buss2", double step = 1e-3) {
  MotionSetup setup;
  setup.inertia = PrincipalInertia::fromMoments({1, 2, 3});
  setup.attitude = Quaterniond(2, 0, 0, 0);  // to be normalised
  setup.omega_body = {0.01, 1, 0.02};
  setup.method = method;
  setup.step = step;
  return setup;
}

bool same(const MotionState& a, const MotionState& b) {
  return a.time == b.time && a.attitude.coeffs() == b.attitude.coeffs() && a.omega_body == b.omega_body &&
         a.omega_world == b.omega_world && a.momentum_world == b.momentum_world && a.kinetic_energy == b.kinetic_energy;
}

TEST(Motion, startsWhereItWasTold) {
  const MotionState state = Motion(wingnut()).at(0);
  EXPECT_EQ(state.attitude.coeffs(), Quaterniond::Identity().coeffs());
  EXPECT_LE((state.omega_body - Vector3d(0.01, 1, 0.02)).norm(), 1e-16);
  EXPECT_LE((state.momentum_world - Vector3d(0.01, 2, 0.06)).norm(), 1e-15);
  EXPECT_NEAR(state.kinetic_energy, 0.5 * (1e-4 + 2 + 3 * 4e-4), 1e-15);
}

TEST(Motion, stateDependsOnTheTimeAlone) {
  for (const Method& method : freeMethods()) {
    Motion reference(wingnut(method.name)), other(wingnut(method.name));
    std::vector<double> times;
    for (int i = -400; i <= 400; ++i) times.push_back(0.01234567 * i);
    times.insert(times.end(), {1.0, 3.0, 0.1 * 3, 1e-9, -1e-9, 5e-324, -0.0});
    std::vector<MotionState> states;
    for (const double t : times) states.push_back(reference.at(t));
    std::mt19937 random(8);
    for (int i = 0; i < 2000; ++i) {
      const std::size_t k = random() % times.size();
      ASSERT_TRUE(same(other.at(times[k]), states[k])) << method.name << ", t = " << times[k];
    }
    // A visit far away, and a fresh motion that goes there at once.
    other.at(57.3);
    other.at(-23.9);
    for (const std::size_t k : {0u, 100u, 400u, 800u}) {
      EXPECT_TRUE(same(other.at(times[k]), states[k]));
      EXPECT_TRUE(same(Motion(wingnut(method.name)).at(times[k]), states[k]));
    }
  }
}

TEST(Motion, atGridTimesNoPartialStepIsNoticed) {
  // h = 2⁻¹⁰: the grid's times are exact.
  const double h = 1.0 / 1024;
  Motion motion(wingnut("rk4", h));
  RotationState state = RotationState::fromOmega({1, 2, 3}, Quaterniond::Identity(), {0.01, 1, 0.02});
  findMethod("rk4")->make({1, 2, 3})->advance(state, 0, h, 3000);
  EXPECT_EQ(motion.at(3000 * h).attitude.coeffs(), state.attitude.coeffs());
  findMethod("rk4")->make({1, 2, 3})->advance(state, 0, 0.25 * h, 1);
  EXPECT_EQ(motion.at(3000.25 * h).attitude.coeffs(), state.attitude.coeffs());
}

TEST(Motion, gridTimesThatAreNotExactDoNotJump) {
  Motion motion(wingnut("rk4", 0.1));
  for (int n = 1; n < 2000; ++n) {
    const double t = n * 0.1;
    const MotionState at = motion.at(t), before = motion.at(std::nextafter(t, 0)),
                      after = motion.at(std::nextafter(t, 1e9));
    EXPECT_LE(angleBetween(at.attitude, before.attitude), 1e-12) << t;
    EXPECT_LE(angleBetween(at.attitude, after.attitude), 1e-12) << t;
  }
}

TEST(Motion, timeReversal) {
  // The motion at −t is that at t of the same body spinning the other way.
  for (const Method& method : freeMethods()) {
    MotionSetup reversed = wingnut(method.name);
    reversed.omega_body = -reversed.omega_body;
    Motion a(wingnut(method.name)), b(reversed);
    for (const double t : {0.0005, 1.0, 3.3, 20.0}) {
      const MotionState there = a.at(-t), mirror = b.at(t);
      EXPECT_LE(angleBetween(there.attitude, mirror.attitude), 1e-12);
      EXPECT_LE((there.omega_body + mirror.omega_body).norm(), 1e-12);
    }
  }
}

TEST(Motion, tensorInTurnedAxesIsTheSamePhysicalMotion) {
  Draws draws;
  for (int i = 0; i < 20; ++i) {
    // Body axes B are turned by S from the principal axes P: v_B = S v_P.
    const Quaterniond s = draws.attitude();
    const Eigen::Matrix3d turn = s.toRotationMatrix();
    MotionSetup principal = wingnut("rk4");
    principal.attitude = draws.attitude();
    principal.omega_body = draws.vector();
    MotionSetup turned = principal;
    turned.inertia = PrincipalInertia::fromTensor(turn * Vector3d(1, 2, 3).asDiagonal() * turn.transpose());
    turned.attitude = principal.attitude * s.conjugate();
    turned.omega_body = s * principal.omega_body;
    Motion a(principal), b(turned);
    for (const double t : {0.0, 1.0, -4.2}) {
      const MotionState p = a.at(t), q = b.at(t);
      EXPECT_LE(angleBetween(p.attitude * s.conjugate(), q.attitude), 1e-13);
      EXPECT_LE((s * p.omega_body - q.omega_body).norm(), 1e-13);
      EXPECT_LE((p.omega_world - q.omega_world).norm(), 1e-13);
      EXPECT_LE((p.momentum_world - q.momentum_world).norm(), 1e-13);
      EXPECT_NEAR(p.kinetic_energy, q.kinetic_energy, 1e-13);
      EXPECT_NEAR(q.attitude.norm(), 1, 4e-16);
      // Among themselves: ω = RΩ, L = R·M·Ω, E = ½Ω·MΩ.
      EXPECT_LE((q.attitude * q.omega_body - q.omega_world).norm(), 1e-14);
      EXPECT_LE((q.attitude * (turned.inertia.tensor() * q.omega_body) - q.momentum_world).norm(), 3e-14);
      EXPECT_NEAR(q.kinetic_energy, 0.5 * q.omega_body.dot(turned.inertia.tensor() * q.omega_body), 1e-14);
    }
  }
}

TEST(Motion, translationRidesAlong) {
  MotionSetup setup = wingnut();
  EXPECT_EQ(Motion(setup).at(3).position, Vector3d(0, 0, 0));
  const MotionState without = Motion(setup).at(-3);
  setup.translation = Translation{{1, 2, 3}, {0, 0, 10}, {0, 0, -4}};
  const MotionState with = Motion(setup).at(-3);
  EXPECT_TRUE(same(with, without));
  EXPECT_LE((with.position - Vector3d(1, 2, 3 - 30 - 18)).norm(), 1e-14);
  EXPECT_LE((with.velocity - Vector3d(0, 0, 22)).norm(), 1e-14);
}

TEST(Motion, stepsToAndPrepare) {
  Motion motion(wingnut("buss2", 0.5));
  std::atomic<bool> cancel{false};
  EXPECT_EQ(motion.stepsTo(100.2), 200);
  EXPECT_EQ(motion.stepsTo(-100.2), 200);
  EXPECT_TRUE(motion.prepare(100.2, cancel));
  EXPECT_EQ(motion.stepsTo(100.2), 0);
  EXPECT_EQ(motion.stepsTo(-100.2), 200);
  EXPECT_TRUE(same(motion.at(100.2), Motion(wingnut("buss2", 0.5)).at(100.2)));
  cancel = true;
  EXPECT_FALSE(motion.prepare(-1e6, cancel));
  EXPECT_EQ(motion.stepsTo(-1e6), 2e6);
  EXPECT_EQ(motion.stepsTo(1e300), std::numeric_limits<double>::infinity());
  EXPECT_EQ(motion.stepsTo(-std::numeric_limits<double>::infinity()), std::numeric_limits<double>::infinity());
  EXPECT_EQ(motion.stepsTo(std::numeric_limits<double>::quiet_NaN()), std::numeric_limits<double>::infinity());
}

TEST(Motion, timesBeyondTheGridAreRefused) {
  Motion motion(wingnut());
  EXPECT_THROW(motion.at(1e300), std::out_of_range);
  EXPECT_THROW(motion.at(std::numeric_limits<double>::quiet_NaN()), std::out_of_range);
}

TEST(Motion, aStateThatIsNotFiniteIsNoState) {
  // |Ω|h = 1000: the classical Runge–Kutta method blows up.
  MotionSetup wild = wingnut("rk4", 10);
  wild.omega_body = {60, 70, 40};
  Motion motion(wild);
  EXPECT_NO_THROW(motion.at(0));
  EXPECT_THROW(motion.at(1e4), std::range_error);
  EXPECT_NO_THROW(motion.at(0));

  MotionSetup thrown = wingnut();
  thrown.translation = Translation{{0, 0, 0}, {0, 0, 1e308}, {0, 0, 0}};
  EXPECT_THROW(Motion(thrown).at(20), std::range_error);
}

TEST(Motion, startsWhoseEnergyDoublesDoNotHoldAreRefused) {
  const auto start = [](const Vector3d& moments, const Vector3d& omega) {
    MotionSetup setup;
    setup.inertia = PrincipalInertia::fromMoments(moments);
    setup.omega_body = omega;
    return setup;
  };
  for (const double size : {1e-150, 1e-10, 1e10, 1e150}) EXPECT_NO_THROW(Motion(start({1, 2, 3}, {0, size, size})));
  EXPECT_NO_THROW(Motion(start({1e-5, 1e-5, 1e-5}, {0, 0, 0})));  // rest
  for (const double size : {1e-155, 1e-200, 5e-324, 1e155, 1e308}) {
    EXPECT_THROW(Motion(start({1, 2, 3}, {0, size, 0})), std::invalid_argument) << size;
  }
  // E fits, |L|² does not, and the other way round.
  EXPECT_THROW(Motion(start({1e-200, 1e-200, 1e-200}, {1, 0, 0})), std::invalid_argument);
  EXPECT_THROW(Motion(start({1e200, 1e200, 1e200}, {1e20, 0, 0})), std::invalid_argument);
  EXPECT_THROW(Motion(start({1e200, 1e200, 1e200}, {0, 1e-300, 0})), std::invalid_argument);
  EXPECT_EQ(outOfRange(PrincipalInertia::fromMoments({1, 2, 3}), {0, 1e-200, 0}),
            "the kinetic energy is too small for double precision (below 2.3e-308)");
}

TEST(Motion, badSetupsAreRefused) {
  const auto refused = [](const auto& spoil) {
    MotionSetup setup = wingnut();
    spoil(setup);
    EXPECT_THROW(Motion{setup}, std::invalid_argument);
  };
  refused([](MotionSetup& s) { s.method = "euler"; });
  refused([](MotionSetup& s) { s.method = kClosedForm; });  // which takes no step
  refused([](MotionSetup& s) { s.step.reset(); });          // which a stepper needs
  refused([](MotionSetup& s) { s.step = 0; });
  refused([](MotionSetup& s) { s.step = -1; });
  refused([](MotionSetup& s) { s.step = std::numeric_limits<double>::infinity(); });
  refused([](MotionSetup& s) { s.step = std::numeric_limits<double>::quiet_NaN(); });
  refused([](MotionSetup& s) { s.attitude = Quaterniond(0, 0, 0, 0); });
  refused([](MotionSetup& s) { s.attitude.x() = std::numeric_limits<double>::quiet_NaN(); });
  refused([](MotionSetup& s) { s.omega_body.x() = std::numeric_limits<double>::quiet_NaN(); });
}

}  // namespace
}  // namespace poinsot
