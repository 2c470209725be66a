// The order of each method that takes torques, under each effect.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "comparisons.h"
#include "draws.h"
#include "poinsot/core/method.h"
#include "torqued_bodies.h"

namespace poinsot {
namespace {

double apart(const MotionState& a, const MotionState& b) {
  return angle(a.attitude, b.attitude) + relativeDifference(a.omega_body, b.omega_body);
}

MotionState stateAt(const std::vector<Effect>& effects, const std::string& method, double t, double step) {
  return Motion(torquedBody(effects, method, step)).at(t);
}

TEST(TorqueOrder, theTruthIsTheSameByAnotherOrderAndStep) {
  for (const NamedEffects& one : eachEffect()) {
    const double t = 3.2;
    const MotionState a = stateAt(one.effects, "taylor24", t, t / 128),
                      b = stateAt(one.effects, "taylor12", t, t / 1011);
    EXPECT_LE(angle(a.attitude, b.attitude), 2e-15) << one.name;
    EXPECT_LE(relativeDifference(a.omega_body, b.omega_body), 2e-15) << one.name;
  }
}

// From the error at t by steps and by their halves.
TEST(TorqueOrder, ofMethodsUpToFourIsTheOneInTheTable) {
  for (const Method& method : torquedMethods()) {
    if (method.order > 4) continue;
    std::printf("%-8s", method.name);
    for (const NamedEffects& one : eachEffect()) {
      if (one.damped && !method.takes_damping) continue;
      std::vector<double> orders;
      for (const double t : {1.8, 3.2, 5.1, 6.3, 7.7, 9.4, -2.9, -5.7}) {
        const MotionState truth = stateAt(one.effects, "taylor24", t, 0.02);
        double step = 0.2, error = 1;
        while (error > (method.order == 2 ? 1e-4 : 1e-7)) {
          step *= 0.5;
          error = apart(stateAt(one.effects, method.name, t, step), truth);
        }
        orders.push_back(std::log2(error / apart(stateAt(one.effects, method.name, t, 0.5 * step), truth)));
      }
      std::sort(orders.begin(), orders.end());
      const double median = 0.5 * (orders[3] + orders[4]);
      std::printf("  %.3f", median);
      // Steps that are cut at switches are not halved all alike.
      const bool cut = std::string(one.name) == "torque_schedule" || std::string(one.name) == "all of them";
      EXPECT_NEAR(median, method.order, cut ? 0.8 : 0.05) << method.name << ", " << one.name;
    }
    std::printf("\n");
  }
}

// Of one step the error is c·hᵖ⁺¹(1 + O(h)), which for p = 24 shows above rounding only where O(h) is no small part:
// the median of many starts, to ± 1.
TEST(TorqueOrder, ofTaylorsMethodsIsTheOneInTheirNames) {
  for (const NamedEffects& one : eachEffect()) {
    if (std::string(one.name) == "torque_schedule") continue;  // piece by piece it is a constant torque
    const PrincipalInertia inertia = torquedBody({}).inertia;
    std::vector<Effect> effects;
    for (const Effect& effect : one.effects) {
      if (!std::holds_alternative<TorqueSchedule>(effect)) effects.push_back(effect);
    }
    const Torques torques = sumOf(inertia, effects);
    const auto fine = findMethod("taylor24")->make(torques);
    std::printf("%-24s", one.name);
    for (const Method& method : torquedMethods()) {
      if (method.order < 8) continue;
      const auto stepper = method.make(torques);
      Draws draws;
      std::vector<double> orders;
      for (int i = 0; i < 40; ++i) {
        RotationState start = RotationState::fromOmega(inertia.moments(), draws.attitude(), draws.direction());
        if (torques.slug()) start.slug_omega = draws.vector();
        const auto error = [&](double h) -> double {
          RotationState a = start, b = start;
          if (stepper->advanceFrom(a, 0, h).evaluations > method.order) return HUGE_VAL;  // cut: the order of its parts
          for (int k = 0; k < 16; ++k) fine->advanceFrom(b, k * h / 16, h / 16);
          return (a.momentum_principal - b.momentum_principal).norm();
        };
        double h = 4;
        while (error(h) > 3e-11) h *= 0.9;
        const double coarse = error(h), half = error(0.9 * h);
        if (half > 1e-13) orders.push_back(std::log(coarse / half) / std::log(1 / 0.9) - 1);
      }
      ASSERT_GE(orders.size(), 10u) << method.name << ", " << one.name;
      std::sort(orders.begin(), orders.end());
      const double median = orders[orders.size() / 2];
      std::printf("  %.2f", median);
      EXPECT_NEAR(median, method.order, 1) << method.name << ", " << one.name;
    }
    std::printf("\n");
  }
}

// aba84: beside dmv8's own error, a·h⁸, torques of strength ε make b·εh⁸ + c·ε²h⁴.
TEST(TorqueOrder, ofAba84IsEightForWeakTorques) {
  const double t = 20;
  for (std::size_t k = 0; k < eachEffect().size(); ++k) {
    const NamedEffects one = eachEffect()[k];
    if (one.damped || std::string(one.name) == "torque_schedule") continue;
    const auto error = [&](double strength, int n) {
      const std::vector<Effect> effects = eachEffect(strength)[k].effects;
      return apart(stateAt(effects, "aba84", t, t / n), stateAt(effects, "taylor24", t, 0.05));
    };
    const double weak = std::log2(error(1e-5, 20) / error(1e-5, 40)),
                 strong = std::log2(error(0.1, 80) / error(0.1, 160)),
                 in_strength = std::log10(error(0.1, 160) / error(0.01, 160));
    std::printf("%-24s order %.2f at eps 1e-5, %.2f at eps 0.1; the latter's error grows as eps^%.2f\n", one.name, weak,
                strong, in_strength);
    EXPECT_NEAR(weak, 8, 0.2) << one.name;
    EXPECT_NEAR(strong, 4, 0.1) << one.name;
    EXPECT_NEAR(in_strength, 2, 0.4) << one.name;
  }
}

}  // namespace
}  // namespace poinsot
