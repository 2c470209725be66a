// The invariants of each effect, and how well each method keeps them. doc/equations.md shows the table that is printed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>

#include "comparisons.h"
#include "poinsot/core/method.h"
#include "torqued_bodies.h"

namespace poinsot {
namespace {

using Eigen::Vector3d;

constexpr double kStep = 0.05, kTime = 200;  // s: |Ω|h is about 0.05, and the body turns some thirty times

/** An invariant, and the unit in which its change is given. */
struct Invariant {
  const char* name;
  std::vector<Effect> effects;
  std::function<Vector3d(const MotionState&)> value;
  bool damped = false;
};

MotionSetup bodyFor(const Invariant& one, const std::string& method, double step) {
  MotionSetup setup = torquedBody(one.effects, method, step);
  if (std::string(one.name).find("Lagrange") != std::string::npos) {
    setup.inertia = PrincipalInertia::fromMoments({1.5, 1.5, 0.7});
    setup.omega_body = {0.3, -0.2, 3};
  }
  return setup;
}

const GravityTorque kWeight{1, {0, 0, -2}, {0.1, -0.2, 0.4}};
const GravityTorque kOnAxis{1, {0, 0, -2}, {0, 0, 0.4}};
const GravityGradient kOrbit{0.6, {1, 2, 2}, {2, 1, -2}};

double potential(const GravityTorque& weight, const MotionState& s) {
  return -weight.mass * weight.gravity.dot(s.attitude * weight.centre_of_mass);
}

std::vector<Invariant> invariants() {
  const Vector3d torque(0.002, 0.003, -0.004);  // so that the body is not spun up beyond its step
  const auto energyOfTop = [](const GravityTorque& weight) {
    return [weight](const MotionState& s) { return Vector3d(s.kinetic_energy + potential(weight, s), 0, 0); };
  };
  const auto along = [](const GravityTorque& weight) {
    return [weight](const MotionState& s) { return Vector3d(s.momentum_world.dot(weight.gravity.normalized()), 0, 0); };
  };
  return {
      {"world torque: L - tau t",
       {ConstantTorque{Axes::world, torque}},
       [torque](const MotionState& s) { return Vector3d(s.momentum_world - torque * s.time); }},
      {"schedule: L - impulse",
       {TorqueSchedule{{{0.31, 17.77, Axes::world, torque}, {40.123, 77.7, Axes::world, -torque}}}},
       [torque](const MotionState& s) {
         const double on =
             std::clamp(s.time - 0.31, 0.0, 17.77 - 0.31) - std::clamp(s.time - 40.123, 0.0, 77.7 - 40.123);
         return Vector3d(s.momentum_world - torque * on);
       }},
      {"heavy body: E", {kWeight}, energyOfTop(kWeight)},
      {"heavy body: L along g", {kWeight}, along(kWeight)},
      {"Lagrange top: E", {kOnAxis}, energyOfTop(kOnAxis)},
      {"Lagrange top: L along g", {kOnAxis}, along(kOnAxis)},
      {"Lagrange top: Omega_3", {kOnAxis}, [](const MotionState& s) { return Vector3d(s.omega_body.z(), 0, 0); }},
      {"gravity gradient: Jacobi",
       {kOrbit},
       [](const MotionState& s) {
         const double n = kOrbit.orbit_rate;
         const Vector3d normal = kOrbit.orbit_normal.normalized();
         const Vector3d radial = Eigen::AngleAxisd(n * s.time, normal) * kOrbit.radial_at_start.normalized();
         const Vector3d u = s.attitude.conjugate() * radial;
         const Vector3d moments(1, 1.7, 2.1);
         return Vector3d(
             s.kinetic_energy - n * normal.dot(s.momentum_world) + 1.5 * n * n * u.dot(moments.cwiseProduct(u)), 0, 0);
       }},
      {"slug: L", {InternalDissipation{0.3, 0.2}}, [](const MotionState& s) { return s.momentum_world; }, true},
  };
}

/** The greatest change at every whole second, relative to |L| + E at the start, which are about 1. */
double drift(const Invariant& one, const std::string& method, double step = kStep, double time = kTime) {
  Motion motion(bodyFor(one, method, step));
  const Vector3d start = one.value(motion.at(0));
  double worst = 0;
  for (int t = 1; t <= time; ++t) worst = std::max(worst, (one.value(motion.at(t)) - start).norm());
  return worst / std::max(1.0, start.norm());
}

bool keepsToRounding(const std::string& name, const std::string& method) {
  const bool momentum = name == "world torque: L - tau t" || name == "schedule: L - impulse";
  // Their L changes by the torques' impulse alone.
  if (momentum) return method == "aba84" || method == "buss2";
  // A kick by a weight is horizontal, and free motion leaves L alone; for a Lagrange top both leave Ω₃ alone.
  return method == "aba84" && (name.find("L along g") != std::string::npos || name == "Lagrange top: Omega_3");
}

TEST(EffectInvariants, areKeptAsWellAsTheDocumentSays) {
  std::printf("|Omega|h = 0.05, %g s: greatest change, relative\n%-26s", kTime, "");
  for (const Method& method : torquedMethods()) std::printf("%9s", method.name);
  std::printf("\n");
  for (const Invariant& one : invariants()) {
    std::printf("%-26s", one.name);
    for (const Method& method : torquedMethods()) {
      if (one.damped && !method.takes_damping) {
        std::printf("%9s", "-");
        continue;
      }
      const double change = drift(one, method.name);
      std::printf("  %7.0e", change);
      const double allowed = method.order >= 12 || keepsToRounding(one.name, method.name) ? 5e-13
                             : method.order == 8                                          ? 1e-10
                             : method.order == 4                                          ? 2e-4
                                                                                          : 0.2;
      EXPECT_LE(change, allowed) << one.name << ", " << method.name;
    }
    std::printf("\n");
  }
}

// The check fails for quantities that are not invariant.
TEST(EffectInvariants, whatIsNoneChanges) {
  for (Invariant one : invariants()) {
    if (std::string(one.name) == "slug: L") {
      one.value = [](const MotionState& s) { return Vector3d(s.momentum_world - s.attitude * (0.3 * s.slug_omega)); };
    } else if (std::string(one.name).find(": L -") != std::string::npos) {
      one.value = [](const MotionState& s) {
        return Vector3d(s.momentum_world - 1.01 * Vector3d(0.002, 0.003, -0.004) * s.time);
      };
    } else if (std::string(one.name) == "Lagrange top: Omega_3") {
      one.value = [](const MotionState& s) { return Vector3d(s.omega_body.x(), 0, 0); };
    } else {
      one.value = [](const MotionState& s) { return Vector3d(s.kinetic_energy, 0, 0); };
    }
    EXPECT_GT(drift(one, "taylor16"), 1e-3) << one.name;
  }
}

// aba84 is symplectic: over a long time the energy of a weak weight does not drift away, as rk4's does.
TEST(EffectInvariants, aba84KeepsTheEnergyOfAHeavyBodyBounded) {
  const GravityTorque weak{0.02, {0, 0, -2}, {0.1, -0.2, 0.4}};
  Invariant one{
      "", {weak}, [weak](const MotionState& s) { return Vector3d(s.kinetic_energy + potential(weak, s), 0, 0); }};
  const double soon = drift(one, "aba84", 0.4, 200), late = drift(one, "aba84", 0.4, 5000);
  std::printf("aba84, h = 0.4, torque 2 %% : energy off by %.1e in 200 s, %.1e in 5000 s; rk4 %.1e and %.1e\n", soon,
              late, drift(one, "rk4", 0.05, 200), drift(one, "rk4", 0.05, 5000));
  EXPECT_LE(late, 3 * soon);
  EXPECT_GE(drift(one, "rk4", 0.05, 5000), 10 * drift(one, "rk4", 0.05, 200));
}

/** Kinetic energy of body and slug. */
double energy(const MotionState& s, double slug_inertia) {
  return s.kinetic_energy + 0.5 * slug_inertia * s.slug_omega.squaredNorm();
}

TEST(EffectInvariants, aSlugTakesEnergyUntilTheBodySpinsAboutItsLargestAxis) {
  const InternalDissipation slug{0.3, 0.2};
  for (const std::string method : {"taylor8", "taylor16", "taylor24", "rk4", "buss2"}) {
    MotionSetup setup = torquedBody({slug}, method, 0.05);
    setup.omega_body = {1, 0.02, 0.01};  // about the smallest axis, as Explorer 1
    Motion motion(setup);
    const MotionState start = motion.at(0);
    const double least = start.momentum_world.squaredNorm() / (2 * (2.1 + slug.slug_inertia));
    double before = energy(start, slug.slug_inertia), rise = 0;
    for (int k = 1; k <= 15000; ++k) {
      const double now = energy(motion.at(0.1 * k), slug.slug_inertia);
      rise = std::max(rise, now - before);
      before = now;
    }
    const MotionState end = motion.at(1500);
    std::printf("%-8s E/E_least - 1 = %.1e, greatest rise of E %.1e, |Omega_3|/|Omega| = 1 - %.1e, |dL|/L %.1e\n",
                method.c_str(), before / least - 1, rise, 1 - std::abs(end.omega_body.z()) / end.omega_body.norm(),
                (end.momentum_world - start.momentum_world).norm() / start.momentum_world.norm());
    EXPECT_LE(rise, 1e-15 * before * 10) << method;
    const bool exact = method[0] == 't';
    EXPECT_NEAR(before / least, 1, exact ? 1e-12 : 0.05) << method;
    EXPECT_GE(std::abs(end.omega_body.z()), (1 - 1e-12) * end.omega_body.norm()) << method;
    EXPECT_LE((end.slug_omega - end.omega_body).norm(), 1e-6) << method;
  }
}

// dE/dt = −c|Ω − σ|², and of damping per axis −ΣcᵢΩᵢ².
TEST(EffectInvariants, energyFallsAtTheRateOfTheFormula) {
  const InternalDissipation slug{0.3, 0.2};
  const ViscousDamping drag{{0.1, 0.2, 0.05}};
  Motion with_slug(torquedBody({slug}, "taylor24", 0.05)), with_drag(torquedBody({drag}, "taylor24", 0.05));
  for (const double t : {0.3, 1.7, 4.4}) {
    const double h = 1e-3;
    const auto rate = [&](auto value) {
      return (8 * (value(t + h) - value(t - h)) - (value(t + 2 * h) - value(t - 2 * h))) / (12 * h);
    };
    const MotionState a = with_slug.at(t), b = with_drag.at(t);
    EXPECT_NEAR(rate([&](double s) { return energy(with_slug.at(s), slug.slug_inertia); }),
                -slug.damping * (a.omega_body - a.slug_omega).squaredNorm(), 1e-11);
    EXPECT_NEAR(rate([&](double s) { return with_drag.at(s).kinetic_energy; }),
                -drag.coefficients.dot(b.omega_body.cwiseAbs2()), 1e-11);
  }
}

TEST(EffectInvariants, aDampedSphereSlowsExponentiallyAboutAFixedAxis) {
  for (const Method& method : torquedMethods()) {
    if (!method.takes_damping) continue;
    MotionSetup setup = torquedBody({ViscousDamping{{0.3, 0.3, 0.3}}}, method.name, 0.05);
    setup.inertia = PrincipalInertia::fromMoments({2, 2, 2});
    Motion motion(setup);
    const Vector3d axis = setup.omega_body.normalized();
    double speed_off = 0, angle_off = 0;
    for (const double t : {0.5, 3.0, 30.0, 200.0, -5.0}) {
      const MotionState state = motion.at(t);
      const double left = std::exp(-0.15 * t), turned = setup.omega_body.norm() * -std::expm1(-0.15 * t) / 0.15;
      speed_off =
          std::max(speed_off, (state.omega_body - left * setup.omega_body).norm() / (left * setup.omega_body.norm()));
      angle_off = std::max(angle_off, angle(state.attitude, setup.attitude.normalized() *
                                                                Eigen::Quaterniond(Eigen::AngleAxisd(turned, axis))));
    }
    std::printf("%-8s Omega off by %.1e, attitude by %.1e rad\n", method.name, speed_off, angle_off);
    const double allowed = method.order >= 8 ? 2e-14 : method.order == 4 ? 1e-6 : 1e-2;
    EXPECT_LE(speed_off, allowed) << method.name;
    EXPECT_LE(angle_off, allowed) << method.name;
  }
}

}  // namespace
}  // namespace poinsot
