// Effects on a body: sums, equations, switching times, ways to a state, refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include "comparisons.h"
#include "draws.h"
#include "poinsot/core/method.h"
#include "poinsot/core/no_convergence.h"
#include "poinsot/core/step_limits.h"
#include "torqued_bodies.h"

namespace poinsot {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

const double kInfinite = std::numeric_limits<double>::infinity(), kNaN = std::nan("");

bool same(const MotionState& a, const MotionState& b) {
  return a.time == b.time && a.attitude.coeffs() == b.attitude.coeffs() && a.omega_body == b.omega_body &&
         a.momentum_world == b.momentum_world && a.torque_world == b.torque_world && a.slug_omega == b.slug_omega;
}

double apart(const MotionState& a, const MotionState& b) {
  return std::max({angle(a.attitude, b.attitude), relativeDifference(a.omega_body, b.omega_body),
                   relativeDifference(a.slug_omega, b.slug_omega)});
}

std::vector<std::string> methodsFor(const NamedEffects& one) {
  std::vector<std::string> names;
  for (const Method& method : torquedMethods()) {
    if (method.takes_damping || !one.damped) names.push_back(method.name);
  }
  return names;
}

// --- equations -------------------------------------------------------------------------------------------------------

/** τ in body axes as the definitions of the effects say, without Torques. */
Vector3d torqueByDefinition(const std::vector<Effect>& effects, const Matrix3d& inertia, double t, const Matrix3d& r,
                            const Vector3d& omega, const Vector3d& sigma) {
  Vector3d sum = Vector3d::Zero();
  for (const Effect& effect : effects) {
    if (const auto* constant = std::get_if<ConstantTorque>(&effect)) {
      sum += constant->axes == Axes::body ? constant->torque : Vector3d(r.transpose() * constant->torque);
    } else if (const auto* gravity = std::get_if<GravityTorque>(&effect)) {
      sum += gravity->centre_of_mass.cross(r.transpose() * (gravity->mass * gravity->gravity));
    } else if (const auto* gradient = std::get_if<GravityGradient>(&effect)) {
      const Vector3d n = gradient->orbit_normal.normalized(), start = gradient->radial_at_start.normalized();
      const Vector3d radial = Eigen::AngleAxisd(gradient->orbit_rate * t, n) * start;
      const Vector3d u = r.transpose() * radial;
      sum += 3 * gradient->orbit_rate * gradient->orbit_rate * u.cross(inertia * u);
    } else if (const auto* viscous = std::get_if<ViscousDamping>(&effect)) {
      sum -= viscous->coefficients.cwiseProduct(omega);
    } else if (const auto* slug = std::get_if<InternalDissipation>(&effect)) {
      sum -= slug->damping * (omega - sigma);
    } else if (const auto* schedule = std::get_if<TorqueSchedule>(&effect)) {
      for (const auto& s : schedule->segments) {
        if (t < s.from || t >= s.to) continue;
        sum += s.axes == Axes::body ? s.torque : Vector3d(r.transpose() * s.torque);
      }
    }
  }
  return sum;
}

Matrix3d tensorOf(const PrincipalInertia& inertia) {
  const Matrix3d axes = inertia.axes().toRotationMatrix();
  return axes * inertia.moments().asDiagonal() * axes.transpose();
}

MotionSetup withTensor(MotionSetup setup) {
  Matrix3d tensor;
  tensor << 2, 0.3, -0.2, 0.3, 1.5, 0.1, -0.2, 0.1, 1.1;
  setup.inertia = PrincipalInertia::fromTensor(tensor);
  return setup;
}

// MΩ̇ = MΩ×Ω + τ and Ṙ = R·hat(Ω), the derivatives from states on either side.
TEST(Effects, statesObeyTheEquationsOfTheDefinitions) {
  for (const NamedEffects& one : eachEffect()) {
    for (const bool tensor : {false, true}) {
      MotionSetup setup = torquedBody(one.effects, "taylor24", 0.05);
      if (tensor) setup = withTensor(setup);
      const Matrix3d m = tensorOf(setup.inertia);
      Motion motion(setup);
      for (const double t : {-2.2, -0.7, 0.15, 0.7, 1.5, 2.3, 3.4}) {
        const double h = 1e-3;
        const auto derivative = [&](auto value) {
          return ((8 * (value(t + h) - value(t - h)) - (value(t + 2 * h) - value(t - 2 * h))) / (12 * h)).eval();
        };
        const MotionState s = motion.at(t);
        const Vector3d torque =
            torqueByDefinition(one.effects, m, t, s.attitude.toRotationMatrix(), s.omega_body, s.slug_omega);
        const Vector3d omega_dot = derivative([&](double at) { return Vector3d(motion.at(at).omega_body); });
        const Vector3d expected = m.inverse() * ((m * s.omega_body).cross(s.omega_body) + torque);
        EXPECT_LE((omega_dot - expected).norm(), 1e-10 * (1 + expected.norm())) << one.name << " t = " << t;
        EXPECT_LE((s.attitude * torque - s.torque_world).norm(), 1e-14 * (1 + torque.norm())) << one.name;
        // Ṙ by columns, in world axes: ω × column.
        for (int i = 0; i < 3; ++i) {
          const Vector3d e = Vector3d::Unit(i);
          const Vector3d turn = derivative([&](double at) { return Vector3d(motion.at(at).attitude * e); });
          EXPECT_LE((turn - s.omega_world.cross(s.attitude * e)).norm(), 1e-10) << one.name;
        }
        if (motion.torques()->slug()) {
          const auto& slug = *motion.torques()->slug();
          const Vector3d rate = derivative([&](double at) { return Vector3d(motion.at(at).slug_omega); });
          const Vector3d due =
              slug.damping / slug.inertia * (s.omega_body - s.slug_omega) - s.omega_body.cross(s.slug_omega);
          EXPECT_LE((rate - due).norm(), 1e-10) << one.name;
          EXPECT_LE((s.momentum_world - s.attitude * (m * s.omega_body + slug.inertia * s.slug_omega)).norm(), 1e-14);
        }
      }
    }
  }
}

TEST(Effects, aTensorIsTheSameBodyAsItsPrincipalAxes) {
  for (const NamedEffects& one : eachEffect()) {
    // Damping per axis belongs to the axes of the scene: the same body has it in a tensor there. So one number.
    std::vector<Effect> effects = one.effects;
    for (Effect& effect : effects) {
      if (auto* drag = std::get_if<ViscousDamping>(&effect)) drag->coefficients.setConstant(0.15);
    }
    const MotionSetup turned = withTensor(torquedBody(effects, "taylor16", 0.05));
    const Quaterniond p = turned.inertia.axes();  // principal → body
    MotionSetup straight = turned;
    straight.inertia = PrincipalInertia::fromMoments(turned.inertia.moments());
    straight.attitude = turned.attitude.normalized() * p;
    straight.omega_body = p.conjugate() * turned.omega_body;
    for (Effect& effect : straight.effects) {
      const auto into = [&p](Vector3d& v) { v = p.conjugate() * v; };
      if (auto* e = std::get_if<ConstantTorque>(&effect); e && e->axes == Axes::body) into(e->torque);
      if (auto* e = std::get_if<GravityTorque>(&effect)) into(e->centre_of_mass);
      if (auto* e = std::get_if<TorqueSchedule>(&effect)) {
        for (auto& s : e->segments) {
          if (s.axes == Axes::body) into(s.torque);
        }
      }
    }
    for (const std::string& method : methodsFor({one.name, effects, one.damped})) {
      MotionSetup a = turned, b = straight;
      a.method = b.method = method;
      Motion in_body(a), in_principal(b);
      for (const double t : {-2.0, 0.7, 3.0}) {
        const MotionState x = in_body.at(t), y = in_principal.at(t);
        EXPECT_LE(angle(x.attitude * p, y.attitude), 2e-14) << one.name << " " << method;
        EXPECT_LE((p.conjugate() * x.omega_body - y.omega_body).norm(), 2e-14) << one.name << " " << method;
        EXPECT_LE((x.torque_world - y.torque_world).norm(), 5e-14) << one.name << " " << method;
        EXPECT_LE((x.momentum_world - y.momentum_world).norm(), 5e-14) << one.name << " " << method;
      }
    }
  }
}

TEST(Effects, dampingPerAxisOfATensorIsOfItsAxes) {
  const MotionSetup setup = withTensor(torquedBody({ViscousDamping{{0.3, 0, 0.1}}}, "taylor16", 0.01));
  Motion motion(setup);
  for (const double t : {0.0, 1.0, 2.5}) {
    const MotionState s = motion.at(t);
    const Vector3d torque = s.attitude.conjugate() * s.torque_world;
    EXPECT_LE((torque + Vector3d(0.3, 0, 0.1).cwiseProduct(s.omega_body)).norm(), 1e-15) << t;
  }
}

TEST(Effects, oneAfterTheOtherOrTogetherAddUp) {
  Draws draws;
  const PrincipalInertia inertia = withTensor(torquedBody({})).inertia;
  const std::vector<NamedEffects> all = eachEffect();
  for (int i = 0; i < 20; ++i) {
    const Quaterniond q = draws.attitude();
    const Vector3d omega = draws.vector(), sigma = draws.vector();
    const double t = draws.uniform(-1, 3);
    Vector3d sum = Vector3d::Zero();
    const auto at = [&](const std::vector<Effect>& effects) {
      const Torques torques = sumOf(inertia, effects);
      return torques.at(t, torques.constant(torques.intervalAt(t)), q, omega, sigma);
    };
    for (std::size_t k = 0; k + 1 < all.size(); ++k) sum += at(all[k].effects);
    EXPECT_LE((at(all.back().effects) - sum).norm(), 1e-14);
    std::vector<Effect> reversed(all.back().effects.rbegin(), all.back().effects.rend());
    EXPECT_LE((at(reversed) - sum).norm(), 1e-14);
  }
}

// Many forces are kept as three at most.
TEST(Torques, ofAnyNumberOfForcesIsTheirSum) {
  Draws draws;
  const PrincipalInertia inertia = withTensor(torquedBody({})).inertia;
  for (const int count : {1, 2, 3, 4, 5, 9}) {
    Torques torques(inertia);
    std::vector<std::pair<Vector3d, Vector3d>> forces;
    for (int i = 0; i < count; ++i) {
      forces.emplace_back(draws.vector(), i % 4 == 3 ? forces[0].second : draws.vector());  // one direction twice
      torques.addForce(forces.back().first, forces.back().second);
    }
    EXPECT_LE(torques.fields().size(), 3u);
    for (int i = 0; i < 10; ++i) {
      const Quaterniond q = draws.attitude();  // body → world
      Vector3d sum = Vector3d::Zero();
      for (const auto& [lever, force] : forces) sum += lever.cross(q.conjugate() * force);
      const Vector3d principal =
          torques.at(0, torques.constant(0), q * inertia.axes(), Vector3d::Zero(), Vector3d::Zero());
      EXPECT_LE((inertia.axes() * principal - sum).norm(), 1e-14) << count;
    }
    // And a stepper carries them: a step is the one that the sum of levers times forces takes.
    RotationState state = RotationState::fromOmega(inertia.moments(), draws.attitude(), {0.1, 0.2, 0.3});
    RotationState other = state;
    findMethod("taylor24")->make(torques)->advanceFrom(state, 0, 0.1);
    const auto rk4 = findMethod("rk4")->make(torques);
    for (int i = 0; i < 1000; ++i) rk4->advanceFrom(other, 0, 1e-4);
    EXPECT_LE(angle(state.attitude, other.attitude), 1e-14) << count;
    EXPECT_LE((state.momentum_principal - other.momentum_principal).norm(), 1e-14) << count;
  }
}

TEST(Torques, refuseWhatIsOutOfRange) {
  const auto refused = [](const Effect& effect) {
    EXPECT_THROW(sumOf(PrincipalInertia::fromMoments({1, 2, 3}), {effect}), std::invalid_argument) << textOf(effect);
    MotionSetup setup = torquedBody({effect});
    EXPECT_THROW(Motion{setup}, std::invalid_argument) << textOf(effect);
  };
  for (const double bad : {kNaN, kInfinite, -kInfinite}) {
    for (const Axes axes : {Axes::body, Axes::world}) {
      refused(ConstantTorque{axes, {0, bad, 0}});
      refused(TorqueSchedule{{{0, 1, axes, {bad, 0, 0}}}});
    }
    refused(GravityTorque{bad, {0, 0, -1}, {0, 0, 1}});
    refused(GravityTorque{1, {0, 0, bad}, {0, 0, 1}});
    refused(GravityTorque{1, {0, 0, -1}, {bad, 0, 1}});
    refused(GravityGradient{bad, {0, 0, 1}, {1, 0, 0}});
    refused(GravityGradient{1, {0, 0, bad}, {1, 0, 0}});
    refused(GravityGradient{1, {0, 0, 1}, {1, bad, 0}});
    refused(ViscousDamping{{0, bad, 0}});
    refused(InternalDissipation{bad, 1});
    refused(InternalDissipation{1, bad});
  }
  refused(GravityTorque{1e200, {0, 0, -1e200}, {0, 0, 1}});
  refused(GravityGradient{0, {0, 0, 1}, {1, 0, 0}});
  refused(GravityGradient{-1, {0, 0, 1}, {1, 0, 0}});
  refused(GravityGradient{1, {0, 0, 0}, {1, 0, 0}});
  refused(GravityGradient{1, {0, 0, 1}, {0, 0, 0}});
  refused(GravityGradient{1, {0, 0, 1}, {1, 0, 1e-6}});
  refused(ViscousDamping{{0, -1e-300, 0}});
  refused(InternalDissipation{0, 1});
  refused(InternalDissipation{-1, 1});
  refused(InternalDissipation{1, -1});
  refused(TorqueSchedule{{{1, 1, Axes::body, {1, 0, 0}}}});
  refused(TorqueSchedule{{{2, 1, Axes::body, {1, 0, 0}}}});
  refused(TorqueSchedule{{{kNaN, 1, Axes::body, {1, 0, 0}}}});
}

TEST(Torques, twoOrbitsOrTwoSlugsDoNotGoTogether) {
  const GravityGradient orbit{1, {0, 0, 1}, {1, 0, 0}};
  const InternalDissipation slug{1, 1};
  EXPECT_THROW(Motion(torquedBody({orbit, orbit})), std::invalid_argument);
  EXPECT_THROW(Motion(torquedBody({slug, slug})), std::invalid_argument);
  EXPECT_NO_THROW(Motion(torquedBody({orbit, slug})));
}

TEST(Torques, theImpulseIsTheIntegralOfWhatIsConstantInTheWorld) {
  const Torques torques = sumOf(PrincipalInertia::fromMoments({1, 2, 3}),
                                {ConstantTorque{Axes::world, {1, 0, 0}},
                                 TorqueSchedule{{{-2, -1, Axes::world, {0, 4, 0}}, {1, 3, Axes::world, {0, 0, 8}}}}});
  EXPECT_TRUE(torques.momentumIsKnown());
  EXPECT_EQ(torques.impulseWorld(2), Vector3d(2, 0, 8));
  EXPECT_EQ(torques.impulseWorld(5), Vector3d(5, 0, 16));
  EXPECT_EQ(torques.impulseWorld(-1.5), Vector3d(-1.5, -2, 0));
  EXPECT_EQ(torques.impulseWorld(-7), Vector3d(-7, -4, 0));
  EXPECT_FALSE(
      sumOf(PrincipalInertia::fromMoments({1, 2, 3}), {ConstantTorque{Axes::body, {1, 0, 0}}}).momentumIsKnown());
  EXPECT_FALSE(sumOf(PrincipalInertia::fromMoments({1, 2, 3}), {ViscousDamping{{1, 0, 0}}}).momentumIsKnown());
}

TEST(Effects, aMethodForFreeBodiesTakesNoneAndSaysWhy) {
  const std::vector<Effect> weight = {GravityTorque{1, {0, 0, -1}, {0, 0, 1}}};
  const auto message = [](MotionSetup setup) -> std::string {
    try {
      const Motion motion(setup);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  MotionSetup closed = torquedBody(weight, kClosedForm);
  closed.step.reset();
  EXPECT_NE(message(closed).find("closed_form\", the motion of a free body: gravity_torque acts on this one"),
            std::string::npos)
      << message(closed);
  for (const Method& method : freeMethods()) {
    if (method.make_torqued) continue;
    const std::string refusal = message(torquedBody(weight, method.name));
    EXPECT_NE(refusal.find("expected one of taylor8, "), std::string::npos) << refusal;
    EXPECT_NE(refusal.find(std::string("got \"") + method.name + "\", which takes no torques"), std::string::npos)
        << refusal;
  }
  EXPECT_NE(message(torquedBody({ViscousDamping{{1, 1, 1}}}, "aba84")).find("not damping or dissipation"),
            std::string::npos);
  EXPECT_NE(message(torquedBody({InternalDissipation{1, 1}}, "aba84")).find("not damping or dissipation"),
            std::string::npos);
  for (const double step : {0.0, -1.0, kNaN, kInfinite}) {
    EXPECT_THROW(Motion(torquedBody(weight, "taylor8", step)), std::invalid_argument) << step;
  }
  EXPECT_THROW(Motion(torquedBody({}, "taylor8")), std::invalid_argument);  // of a free body
}

// --- times -----------------------------------------------------------------------------------------------------------

// With any step, a schedule equals the sequence of its pieces, each started where the one before ended.
TEST(Schedule, switchesAreHitExactly) {
  const std::vector<TorqueSchedule::Segment> segments = {{0.3, 1.1, Axes::body, {0.5, 0.2, -0.3}},
                                                         {1.1, 1.7000000001, Axes::world, {-0.4, 0.1, 0.6}},
                                                         {2.05, 2.051, Axes::body, {40, -30, 60}}};
  const std::vector<double> cuts = {0, 0.3, 1.1, 1.7000000001, 2.05, 2.051, 3};
  for (const Method& method : torquedMethods()) {
    // Pieces by hand, by a method that needs no care at their steps.
    MotionState state = Motion(torquedBody({ConstantTorque{}})).at(0);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      ConstantTorque piece;
      for (const auto& s : segments) {
        if (s.from <= cuts[i] && cuts[i] < s.to) piece = {s.axes, s.torque};
      }
      MotionSetup setup = torquedBody({piece}, "taylor24", 0.05);
      setup.attitude = state.attitude;
      setup.omega_body = state.omega_body;
      state = Motion(setup).at(cuts[i + 1] - cuts[i]);
    }
    for (const double step : {0.01, 0.073, 0.5}) {
      if (!method.cuts_steps && step > 0.1) continue;
      Motion motion(torquedBody({TorqueSchedule{segments}}, method.name, step));
      const double off = apart(motion.at(3), state);
      const double truncation = 4e-15 + 10 * std::pow(0.75 * step, method.order);
      EXPECT_LE(off, truncation) << method.name << " " << step;
    }
  }
}

// The test above would notice a switch that is missed by half a step.
TEST(Schedule, aSwitchThatIsMissedByLittleIsSeen) {
  const auto end = [](double to) {
    return Motion(torquedBody({TorqueSchedule{{{0.3, to, Axes::body, {0.5, 0.2, -0.3}}}}}, "taylor24", 0.073)).at(3);
  };
  EXPECT_GT(apart(end(1.1), end(1.1 + 1e-13)), 1e-14);
}

TEST(Schedule, atASwitchTheTorqueIsTheLaterOne) {
  Motion motion(torquedBody({TorqueSchedule{{{1, 2, Axes::world, {1, 2, 3}}}}}, "taylor16", 0.25));
  EXPECT_EQ(motion.at(std::nextafter(1, 0)).torque_world, Vector3d(0, 0, 0));
  EXPECT_LE((motion.at(1).torque_world - Vector3d(1, 2, 3)).norm(), 4e-15);
  EXPECT_LE((motion.at(std::nextafter(2, 0)).torque_world - Vector3d(1, 2, 3)).norm(), 4e-15);
  EXPECT_EQ(motion.at(2).torque_world, Vector3d(0, 0, 0));
}

// Switches on grid points that are rounded: n·0.1 in doubles is not always the double nearest to it.
TEST(Schedule, switchesBesideGridPointsMakeNoSlivers) {
  std::vector<TorqueSchedule::Segment> segments;
  for (int i = 0; i < 20; i += 2) segments.push_back({i / 10.0 + 0.1, (i + 1) / 10.0 + 0.1, Axes::body, {0.3, -1, 2}});
  Motion on_grid(torquedBody({TorqueSchedule{segments}}, "taylor16", 0.1));
  Motion off_grid(torquedBody({TorqueSchedule{segments}}, "taylor16", 0.037));
  EXPECT_LE(apart(on_grid.at(3), off_grid.at(3)), 1e-14);
  EXPECT_EQ(on_grid.work().evaluations, 30 * 16);  // no step more than those of the grid
}

TEST(Effects, theStateDependsOnTheTimeAlone) {
  for (const NamedEffects& one : eachEffect()) {
    for (const std::string& method : methodsFor(one)) {
      const MotionSetup setup = torquedBody(one.effects, method, 0.013);
      Motion reference(setup), other(setup);
      std::vector<double> times;
      for (int i = -60; i <= 60; ++i) times.push_back(0.0471 * i);
      times.insert(times.end(), {0.3, 1.1, 1.9, 2.65, 1e-9, -1e-9, -0.0});
      std::vector<MotionState> states;
      for (const double t : times) states.push_back(reference.at(t));
      std::mt19937 random(8);
      for (int i = 0; i < 300; ++i) {
        const std::size_t k = random() % times.size();
        ASSERT_TRUE(same(other.at(times[k]), states[k])) << one.name << ", " << method << ", t = " << times[k];
      }
      other.at(20), other.at(-7);
      for (const std::size_t k : {0u, 30u, 90u, 120u}) {
        EXPECT_TRUE(same(other.at(times[k]), states[k])) << one.name << ", " << method;
        EXPECT_TRUE(same(Motion(setup).at(times[k]), states[k])) << one.name << ", " << method;
      }
    }
  }
}

// From t = −3 on as from 0 to −3 back: the motion started where the other ended runs to where that began.
TEST(Effects, backwardsIsTheWayForwards) {
  for (const NamedEffects& one : eachEffect()) {
    bool depends_on_time = false;
    for (const Effect& effect : one.effects) {
      depends_on_time |=
          std::holds_alternative<TorqueSchedule>(effect) || std::holds_alternative<GravityGradient>(effect);
      // A slug starts with the body: another start than where it came to.
      depends_on_time |= std::holds_alternative<InternalDissipation>(effect);
    }
    if (depends_on_time) continue;
    MotionSetup setup = torquedBody(one.effects, "taylor24", 0.05);
    const MotionState start = Motion(setup).at(0), back = Motion(setup).at(-3);
    setup.attitude = back.attitude;
    setup.omega_body = back.omega_body;
    EXPECT_LE(apart(Motion(setup).at(3), start), 1e-14) << one.name;
  }
}

// For effects that depend on time, and for the slug, every method goes backwards as well as forwards.
TEST(Effects, allMethodsAgreeOnThePast) {
  for (const NamedEffects& one : eachEffect()) {
    const MotionState truth = Motion(torquedBody(one.effects, "taylor24", 0.05)).at(-2.5);
    for (const std::string& method : methodsFor(one)) {
      const double step = 2e-3;
      const int order = findMethod(method)->order;
      const double allowed = order == 2 ? 1e-4 : order == 4 ? 1e-9 : 1e-14;
      EXPECT_LE(apart(Motion(torquedBody(one.effects, method, step)).at(-2.5), truth), allowed)
          << one.name << " " << method;
    }
  }
}

// --- hard cases ------------------------------------------------------------------------------------------------------

TEST(HardEffects, fromRestEachEffectThatPushesMovesTheBody) {
  for (const NamedEffects& one : eachEffect()) {
    if (one.damped && one.effects.size() == 1) continue;
    MotionSetup setup = torquedBody(one.effects, "taylor24", 0.05);
    setup.omega_body.setZero();
    const MotionState truth = Motion(setup).at(3);
    EXPECT_GT(truth.omega_body.norm(), 0.01) << one.name;
    for (const std::string& method : methodsFor(one)) {
      setup.method = method;
      setup.step = 2e-3;
      const int order = findMethod(method)->order;
      EXPECT_LE(apart(Motion(setup).at(3), truth), order == 2   ? 1e-4
                                                   : order == 4 ? 1e-9
                                                                : 1e-14)
          << one.name << " " << method;
    }
  }
}

// The torque is zero at first, and so are Ω and its derivative.
TEST(HardEffects, fromRestWhereTheTorqueIsZeroAtFirst) {
  for (const Method& method : torquedMethods()) {
    MotionSetup setup = torquedBody({GravityGradient{0.5, {0, 0, 1}, {1, 0, 0}}}, method.name, 1e-3);
    setup.attitude = Quaterniond::Identity();
    setup.omega_body.setZero();
    for (const double tiny : {0.0, 1e-150, 1e-30}) {
      setup.omega_body = {0, 0, tiny};
      const MotionState state = Motion(setup).at(1);
      // In pitch: μ₃θ̈ = −(3/2)n²(μ₂ − μ₁) sin 2(θ − nt); at first θ ≈ n³(μ₂ − μ₁)/μ₃·t³/2.
      const double expected = 3 * 0.125 * (0.7 / 2.1) * 0.5;
      EXPECT_GT(state.omega_body.z(), 0.5 * expected) << method.name << " " << tiny;
      EXPECT_LT(state.omega_body.z(), expected) << method.name << " " << tiny;
    }
  }
}

TEST(HardEffects, atRestWithoutATorqueNothingMoves) {
  for (const Method& method : torquedMethods()) {
    for (const double step : {1e-20, 0.1, 1e20}) {
      for (const bool hanging : {true, false}) {
        MotionSetup setup = torquedBody({}, method.name, step);
        setup.attitude = Quaterniond::Identity();
        setup.omega_body.setZero();
        setup.effects = {GravityTorque{1, {0, 0, hanging ? -1.0 : 1.0}, {0, 0, -1}}};
        const MotionState state = Motion(setup).at(1000 * step);
        EXPECT_EQ(state.omega_body, Vector3d(0, 0, 0)) << method.name << " " << step;
        EXPECT_EQ(state.attitude.coeffs(), setup.attitude.coeffs()) << method.name << " " << step;
      }
    }
  }
}

// Time and mass have no scale of their own.
TEST(HardEffects, scalesOfTimeAndMassDoNotMatter) {
  for (const NamedEffects& one : eachEffect()) {
    for (const std::string& method : methodsFor(one)) {
      const double step = 0.05, t = 2.95;
      const MotionState plain = Motion(torquedBody(one.effects, method, step)).at(t);
      for (const int time : {-40, -7, 0, 7, 40}) {
        for (const int mass : {-40, 0, 40}) {
          // Powers of two: nothing is rounded differently.
          const double second = std::ldexp(1, time), kilogram = std::ldexp(1, mass);
          const double torque = kilogram / (second * second), drag = kilogram / second;
          MotionSetup setup = torquedBody(one.effects, method, step * second);
          setup.inertia = PrincipalInertia::fromMoments(kilogram * setup.inertia.moments());
          setup.omega_body /= second;
          for (Effect& effect : setup.effects) {
            if (auto* e = std::get_if<ConstantTorque>(&effect)) e->torque *= torque;
            if (auto* e = std::get_if<GravityTorque>(&effect)) e->mass *= kilogram, e->gravity /= second * second;
            if (auto* e = std::get_if<GravityGradient>(&effect)) e->orbit_rate /= second;
            if (auto* e = std::get_if<ViscousDamping>(&effect)) e->coefficients *= drag;
            if (auto* e = std::get_if<InternalDissipation>(&effect)) e->slug_inertia *= kilogram, e->damping *= drag;
            if (auto* e = std::get_if<TorqueSchedule>(&effect)) {
              for (auto& s : e->segments) s.from *= second, s.to *= second, s.torque *= torque;
            }
          }
          const MotionState scaled = Motion(setup).at(t * second);
          EXPECT_LE(angle(scaled.attitude, plain.attitude), 1e-14) << one.name << " " << method << " " << time;
          EXPECT_LE((second * scaled.omega_body - plain.omega_body).norm(), 1e-14)
              << one.name << " " << method << " " << time << " " << mass;
        }
      }
    }
  }
}

TEST(HardEffects, momentsOfAnySizeAndRatio) {
  for (const Vector3d& moments : {Vector3d(1e-12, 1.5e-12, 2e-12), Vector3d(1e12, 1.5e12, 2e12), Vector3d(1e-12, 1, 1),
                                  Vector3d(1, 1e6, 1e6), Vector3d(1, 1, 1)}) {
    MotionSetup setup = torquedBody(
        {ConstantTorque{Axes::body, 0.3 * moments.minCoeff() * Vector3d(1, -1, 0.5)}, ViscousDamping{0.1 * moments}},
        "taylor24", 0.05);
    setup.inertia = PrincipalInertia::fromMoments(moments);
    Motion a(setup);
    setup.method = "taylor12";
    setup.step = 0.011;
    Motion b(setup);
    for (const double t : {0.5, 5.0, -1.0})
      EXPECT_LE(apart(a.at(t), b.at(t)), 1e-12) << moments.transpose() << " " << t;
  }
}

// Steps that suffice for a little accuracy, 1e-4 rad over 100 s, are taken whole: cut, they would cost three times
// that.
TEST(HardEffects, stepsThatSufficeAreNotCut) {
  const std::vector<Effect> cases[] = {{ConstantTorque{Axes::body, {1e-3, -5e-4, 8e-4}}},
                                       {GravityGradient{0.02, {0, 0, 1}, {1, 0, 0}}},
                                       {ViscousDamping{{3e-3, 3e-3, 3e-3}}}};
  const double end = 100;
  const int steps = 104;
  for (const std::vector<Effect>& effects : cases) {
    MotionSetup setup = torquedBody(effects, "taylor12", end / steps);
    setup.inertia = PrincipalInertia::fromMoments({1, 2, 3});
    setup.omega_body = {0.6, 0.5, 0.7};
    Motion motion(setup);
    const MotionState state = motion.at(end);
    EXPECT_EQ(motion.work().evaluations, steps * 12) << textOf(effects.front());
    setup.method = "taylor24";
    setup.step = 0.1;
    EXPECT_LE(apart(state, Motion(setup).at(end)), 1e-4) << textOf(effects.front());
  }
}

// A torque that turns the body a thousand times in a step: methods with cuts_steps divide the step as needed.
TEST(HardEffects, hugeTorqueIsFollowedByMethodsThatCutTheirSteps) {
  for (const Method& method : torquedMethods()) {
    if (!method.cuts_steps) continue;
    MotionSetup setup = torquedBody({ConstantTorque{Axes::body, {0, 0, 2.1e4}}}, method.name, 1);
    setup.omega_body = {0, 0, 0};
    Motion motion(setup);
    const MotionState state = motion.at(1);  // Ω₃ = 1e4 t, turned by 5000 rad
    EXPECT_NEAR(state.omega_body.z(), 1e4, 1e-9) << method.name;
    EXPECT_GT(motion.work().evaluations, 100 * method.order) << method.name;
    const Quaterniond exact = setup.attitude.normalized() * Quaterniond(Eigen::AngleAxisd(5000, Vector3d::UnitZ()));
    const double off = angle(state.attitude, exact);
    std::printf("%s turned by 5000 rad in one step of 1 s: %.1e rad, %.0f parts\n", method.name, off,
                double(motion.work().evaluations) / method.order);
    EXPECT_LE(off, 0.5) << method.name;
  }
}

// ch/I from 1e-3 to 1e5: Taylor divides its steps and stays finite; the speed of a body that has come to rest is 0 to
// the accuracy of the start.
TEST(HardEffects, stiffDampingIsCutNotBlownUp) {
  for (const Method& method : torquedMethods()) {
    if (!method.cuts_steps) continue;
    for (const double stiff : {1e-3, 1.0, 10.0, 1e3, 1e5}) {
      const double step = 0.1, c = stiff * 2 / step;
      MotionSetup setup = torquedBody({ViscousDamping{{c, c, c}}}, method.name, step);
      setup.inertia = PrincipalInertia::fromMoments({2, 2, 2});
      const double speed = setup.omega_body.norm();
      Motion motion(setup);
      double worst = 0;
      for (int n = 1; n <= 3; ++n) {
        const double expected = std::exp(-stiff * n);
        worst = std::max(worst, std::abs(motion.at(n * step).omega_body.norm() / speed - expected));
      }
      std::printf("%s ch/I = %g: %.1e of |Omega0|, %.0f parts a step\n", method.name, stiff, worst,
                  double(motion.work().evaluations) / method.order / 3);
      EXPECT_LE(worst, 0.02) << method.name << " " << stiff;
    }
  }
}

// A slug so light that Ω hardly feels it, and so tight that its own rate is stiff: σ is held to its equation too.
TEST(HardEffects, aLightTightSlugFollowsTheBody) {
  for (const Method& method : torquedMethods()) {
    if (!method.cuts_steps) continue;
    MotionSetup setup = torquedBody({InternalDissipation{1e-12, 1e-10}}, method.name, 0.2);  // c/J = 100 1/s
    Motion motion(setup);
    for (const double t : {0.2, 1.0, 4.0}) {
      const MotionState state = motion.at(t);
      // σ lags behind Ω by (J/c)·dΩ/dt.
      EXPECT_LE((state.slug_omega - state.omega_body).norm(), 0.05 * state.omega_body.norm())
          << method.name << " " << t;
    }
  }
}

TEST(HardEffects, whatCannotBeFollowedIsAnErrorNeverNaN) {
  const struct {
    const char* name;
    std::vector<Effect> effects;
    double step, t;
  } cases[] = {{"a torque beyond doubles", {ConstantTorque{Axes::body, {1e300, 0, 1e300}}}, 1e10, 1e12},
               {"damping too stiff to cut", {ViscousDamping{{1e30, 1e30, 1e30}}}, 1, 10},
               {"a slug too tight to cut", {InternalDissipation{1e-30, 1}}, 1, 10},
               {"an orbit too fast to follow", {GravityGradient{1e30, {0, 0, 1}, {1, 0, 0}}}, 1, 10}};
  for (const auto& c : cases) {
    for (const Method& method : torquedMethods()) {
      MotionSetup setup = torquedBody(c.effects, method.name, c.step);
      if (!objectionTo(method, sumOf(setup.inertia, setup.effects)).empty()) continue;
      Motion motion(setup);
      for (const double t : {0.0, 0.3 * c.t, c.t, -c.t}) {
        try {
          const MotionState s = motion.at(t);
          EXPECT_TRUE(s.attitude.coeffs().allFinite() && s.omega_body.allFinite() && s.momentum_world.allFinite() &&
                      s.torque_world.allFinite() && s.slug_omega.allFinite() && std::isfinite(s.kinetic_energy))
              << c.name << ", " << method.name << ", " << t;
          EXPECT_LE(std::abs(s.attitude.norm() - 1), 1e-15) << c.name << ", " << method.name;
        } catch (const std::range_error&) {
        } catch (const NoConvergence&) {
          EXPECT_STREQ(method.name, "aba84") << c.name;
        }
      }
    }
  }
}

// Each alone is finite.
TEST(HardEffects, sumsAndAccelerationsBeyondDoublesAreRefused) {
  const auto moments = PrincipalInertia::fromMoments({1e-3, 2, 3});
  const ConstantTorque huge{Axes::body, {1e308, 0, 0}};
  for (const std::vector<Effect>& effects :
       std::vector<std::vector<Effect>>{{GravityTorque{1, {0, 0, 1e200}, {1e200, 0, 0}}},
                                        {huge},
                                        {ViscousDamping{{1e307, 1, 1}}, ViscousDamping{{1e308, 1, 1}}},
                                        {InternalDissipation{1e-300, 1e200}},
                                        {GravityGradient{1e200, {0, 0, 1}, {1, 0, 0}}}}) {
    EXPECT_THROW(sumOf(moments, effects), std::invalid_argument) << nameOf(effects.front());
  }
  EXPECT_NO_THROW(sumOf(moments, {ConstantTorque{Axes::body, {1e300, 0, 0}}}));
}

// aba84's free motion is dmv8, which does not always get there: the state is then as it was, and the motion as before.
TEST(HardEffects, noConvergenceLeavesTheMotionAsItWas) {
  const std::vector<Effect> effects = {ConstantTorque{Axes::body, {0.5, -2, 1}}};  // faster and faster
  Motion motion(torquedBody(effects, "aba84", 0.5)), other(torquedBody(effects, "aba84", 0.5));
  double lost = 0;
  for (double t = 0.5; t < 1000 && lost == 0; t += 0.5) {
    try {
      motion.at(t);
    } catch (const NoConvergence&) {
      lost = t;
    }
  }
  ASSERT_GT(lost, 2);
  EXPECT_THROW(motion.at(lost + 100), NoConvergence);
  EXPECT_THROW(other.at(lost + 100), NoConvergence);  // from the start in one go
  for (const double t : {lost - 0.5, lost - 1.25, lost - 0.5}) {
    EXPECT_TRUE(same(motion.at(t), other.at(t))) << t;
    EXPECT_TRUE(same(motion.at(t), Motion(torquedBody(effects, "aba84", 0.5)).at(t))) << t;
  }
  // The same with a switch inside the step that fails.
  RotationState state;
  const Torques torques =
      sumOf(PrincipalInertia::fromMoments({1, 1.7, 2.1}), {TorqueSchedule{{{0.01, 0.02, Axes::body, {1, 0, 0}}}}});
  state = RotationState::fromOmega(torques.moments(), Quaterniond::Identity(), {300, 100, 50});
  const RotationState before = state;
  EXPECT_THROW(findMethod("aba84")->make(torques)->advanceFrom(state, 0, 1), NoConvergence);
  EXPECT_EQ(state.momentum_principal, before.momentum_principal);
  EXPECT_EQ(state.attitude.coeffs(), before.attitude.coeffs());
}

TEST(HardEffects, theQuaternionStaysUnitForAMillionSteps) {
  for (const NamedEffects& one : eachEffect()) {
    if (std::string(one.name) != "gravity_torque" && std::string(one.name) != "all of them") continue;
    for (const std::string& method : methodsFor(one)) {
      // A step costs about its order: fewer of the dear ones.
      const bool quick = method == "rk4" || method == "buss2" || method == "taylor8";
      const int steps = quick ? 1000000 : 20000;
      Motion motion(torquedBody(one.effects, method, 0.01));
      for (int k = 1; k <= 4; ++k) {
        const MotionState state = motion.at(0.01 * (steps / 4) * k);
        EXPECT_LE(std::abs(state.attitude.cast<long double>().norm() - 1), 3e-16L) << one.name << " " << method;
      }
    }
  }
}

// --- a step's judgement ----------------------------------------------------------------------------------------------

StepJudgement judged(const std::string& method, const std::vector<Effect>& effects, double step) {
  const MotionSetup setup = torquedBody(effects);
  return judgeStep(*findMethod(method), sumOf(setup.inertia, effects), setup.attitude.normalized(), setup.omega_body,
                   step);
}

TEST(TorqueStepLimits, shortStepsAreSoundAndLongOnesHopeless) {
  using Grade = StepJudgement::Grade;
  for (const NamedEffects& one : eachEffect()) {
    for (const std::string& method : methodsFor(one)) {
      EXPECT_EQ(judged(method, one.effects, 0.01).grade, Grade::sound) << one.name << " " << method;
      if (findMethod(method)->cuts_steps) {
        EXPECT_EQ(judged(method, one.effects, 100).grade, Grade::sound);
        continue;
      }
      for (const double step : {30.0, 1e9}) {
        const StepJudgement judgement = judged(method, one.effects, step);
        EXPECT_EQ(judgement.grade, Grade::hopeless) << one.name << " " << method << " " << step;
        EXPECT_FALSE(judgement.reason.empty());
        ASSERT_GT(judgement.largest_sound, 0) << one.name << " " << method << " " << step;
        EXPECT_EQ(judged(method, one.effects, judgement.largest_sound).grade, Grade::sound);
      }
    }
  }
}

TEST(TorqueStepLimits, stiffDampingIsHopelessForMethodsThatDoNotCut) {
  using Grade = StepJudgement::Grade;
  EXPECT_EQ(judged("rk4", {ViscousDamping{{400, 400, 400}}}, 0.1).grade, Grade::hopeless);
  EXPECT_EQ(judged("buss2", {ViscousDamping{{400, 400, 400}}}, 0.1).grade, Grade::hopeless);
  EXPECT_EQ(judged("rk4", {InternalDissipation{0.01, 4}}, 0.1).grade, Grade::hopeless);
}

}  // namespace
}  // namespace poinsot
