// Motions under torque of which a number is known in closed form, each beside the formula and who gives it.
#include <algorithm>
#include <cmath>

#include "cases.h"
#include "instruments.h"

namespace poinsot::validation {

namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

const double kPi = std::acos(-1.0), kDegree = kPi / 180;

MotionSetup setup(const Vector3d& moments, const Vector3d& omega, const Effect& effect, double step,
                  const Quaterniond& attitude = {1, 0, 0, 0}) {
  MotionSetup setup;
  setup.inertia = PrincipalInertia::fromMoments(moments);
  setup.omega_body = omega;
  setup.attitude = attitude;
  setup.effects = {effect};
  setup.method = "taylor16";
  setup.step = step;
  return setup;
}

// Lagrange's top in steady precession: at an inclination θ and a spin Ω₃ the rate φ̇ of precession is one of the two
// roots of I₁cosθ·φ̇² − I₃Ω₃·φ̇ + mgl = 0 (H. Goldstein, Classical Mechanics, 2nd ed. 1980, §5-7). I₁ = .02, I₃ = .006
// kg·m² about the pivot, m = 1 kg, l = .1 m, g = 9.81 m/s², θ = 30°, Ω₃ = 60 rad/s. Started with Ω = (0, φ̇ sin θ, Ω₃),
// it must neither rise nor fall.
Case lagrange(const std::string& name, const std::string& rate) {
  const double inclination = 30 * kDegree;
  Case one{name, "I₁ = .02, I₃ = .006 kg·m²; mgl = .981 N·m; θ = 30°; Ω₃ = 60 rad/s",
           setup({.02, .02, .006}, {0, std::stod(rate) * std::sin(inclination), 60},
                 GravityTorque{1, {0, 0, -9.81}, {0, 0, .1}}, 0.005,
                 Quaterniond(AngleAxisd(inclination, Vector3d::UnitX())))};
  one.measure = [inclination](const MotionSetup& given) -> std::vector<double> {
    Motion motion(given);
    const Reading azimuth = [](const MotionState& state) {
      const Vector3d axis = state.attitude * Vector3d::UnitZ();
      return std::atan2(axis.y(), axis.x());
    };
    double nutation = 0;
    for (int k = 1; k <= 200; ++k) {
      const Vector3d axis = motion.at(0.01 * k).attitude * Vector3d::UnitZ();
      nutation = std::max(nutation, std::abs(std::atan2(axis.head<2>().norm(), axis.z()) - inclination));
    }
    return {turned(motion, azimuth, 0, 2, 0.01) / 2, nutation / kDegree};
  };
  const char* const source = "Goldstein 1980, root of I₁cosθ·φ̇² − I₃Ω₃·φ̇ + mgl";
  one.claims = {within(0, "rate of steady precession φ̇ [rad/s]", source, rate, 5e-9, 8),
                between(1, "nutation [°]", source, "none", 0, 1e-8, 9)};
  one.swaps = {{0, 2}, {1, 2}};
  return one;
}

// A satellite in circular orbit, its axis of least moment upright, librates in pitch by small angles at the rate
// √(3n²(I_roll − I_yaw)/I_pitch) (P. C. Hughes, Spacecraft Attitude Dynamics, 1986, §9.1; F. P. J. Rimrott 1989).
// Moments of Tiangong-1 (doi 10.1186/s40623-019-0996-8), whose least axis is here upright, which it was not.
Case libration() {
  const double rate = 0.00114;
  Case one{"libration", "I = 16403.01 (yaw), 70915.56 (roll), 76392.38 kg·m² (pitch); n = .00114 rad/s; 1e-5 rad",
           setup({16403.01, 70915.56, 76392.38}, {0, 0, rate}, GravityGradient{rate, {0, 0, 1}, {1, 0, 0}}, 200,
                 Quaterniond(AngleAxisd(1e-5, Vector3d::UnitZ())))};
  one.measure = [rate](const MotionSetup& given) -> std::vector<double> {
    Motion motion(given);
    const Reading pitch = [rate](const MotionState& state) {
      const Vector3d up = state.attitude * Vector3d::UnitX();
      return up.y() * std::cos(rate * state.time) - up.x() * std::sin(rate * state.time);
    };
    const std::vector<double> times = signChanges(motion, pitch, 3, 50, 1000);
    return {times.size() == 3 ? 2 * kPi / (times[2] - times[0]) / rate : kNone};
  };
  one.claims = {within(0, "rate of libration in pitch, by n", "Hughes 1986, √(3(I_roll − I_yaw)/I_pitch)", "1.46313317",
                       5e-8, 8)};
  return one;
}

// A sphere in a viscous medium: Ω keeps its direction and falls as exp(−ct/I); solved at once.
Case dampedSphere() {
  Case one{"damped_sphere", "I = .4 kg·m²; c = .02 N·m·s; Ω = 1, 2, −2 rad/s",
           setup({.4, .4, .4}, {1, 2, -2}, ViscousDamping{{.02, .02, .02}}, 0.5)};
  one.measure = [](const MotionSetup& given) -> std::vector<double> {
    const MotionState state = Motion(given).at(30);
    const Vector3d axis = given.omega_body.normalized();
    return {state.omega_body.norm() / given.omega_body.norm(),
            axis.cross(state.omega_body).norm() / state.omega_body.norm()};
  };
  one.claims = {within(0, "Ω at 30 s, its size by that at the start", "exp(−ct/I)", "0.223130160148", 5e-13, 12),
                between(1, "Ω off its axis, by its size", "exp(−ct/I)", "0", 0, 1e-14, 12)};
  one.swaps = {};  // of a sphere they are equal
  return one;
}

// dL/dt = τ in world axes, whatever the body does: L(t) = L₀ + τt.
Case worldTorque() {
  Case one{"world_torque", "μ = 1, 2, 3 kg·m²; Ω = .1, 1, .2 rad/s; τ = .02, −.03, .05 N·m in the world",
           setup({1, 2, 3}, {.1, 1, .2}, ConstantTorque{Axes::world, {.02, -.03, .05}}, 0.2)};
  one.measure = [](const MotionSetup& given) -> std::vector<double> {
    const MotionState state = Motion(given).at(100);
    return {state.momentum_world[0], state.momentum_world[1], state.momentum_world[2]};
  };
  for (const auto& [i, value] : {std::pair<int, const char*>{0, "2.1"}, {1, "-1"}, {2, "5.6"}}) {
    one.claims.push_back(within(i, "L at 100 s [kg·m²/s]", "L₀ + τt", value, 5e-10, 10));
  }
  return one;
}

// Explorer 1 (1958): a slender body spun about its axis of least moment; its antennas took energy, L stayed, and it was
// found in a flat spin about the axis of largest moment on its first orbit. Here Kane's slug takes the energy, down to
// L²/2(μ₃ + J), and it never comes back. A cylinder of 2.03 m, 14 kg; slug and rates are ours.
Case explorer() {
  Case one{"explorer", "μ = .044, 4.75, 4.8 kg·m²; J = .05 kg·m², c = .02 N·m·s; Ω = 5, .01, .01 rad/s",
           setup({.044, 4.75, 4.8}, {5, .01, .01}, InternalDissipation{.05, .02}, 0.2)};
  one.measure = [](const MotionSetup& given) -> std::vector<double> {
    const auto& slug = std::get<InternalDissipation>(given.effects.at(0));
    const auto energy = [&slug](const MotionState& state) {
      return state.kinetic_energy + slug.slug_inertia / 2 * state.slug_omega.squaredNorm();
    };
    Motion motion(given);
    const MotionState start = motion.at(0);
    double before = energy(start), rise = 0;
    for (int t = 1; t <= 6000; ++t) {
      const double now = energy(motion.at(t));
      rise = std::max(rise, now - before);
      before = now;
    }
    const MotionState end = motion.at(6000);
    const double largest = given.inertia.moments().z() + slug.slug_inertia;
    return {std::atan2(end.omega_body.head<2>().norm(), std::abs(end.omega_body.z())) / kDegree,
            before / (start.momentum_world.squaredNorm() / (2 * largest)),
            (end.momentum_world - start.momentum_world).norm() / start.momentum_world.norm(),
            std::max(0.0, rise) / before};
  };
  one.claims = {
      between(0, "spin from the axis of largest moment, at 6000 s [°]", "Explorer 1, 1958", "flat spin", 0, 0.1, 6),
      within(1, "E of body and slug, by L²/2(μ₃ + J)", "Kane's damper", "1", 5e-7, 9),
      between(2, "change of L, by its size", "Kane's damper", "0", 0, 1e-7, 9),
      between(3, "greatest rise of E in a second, by E", "Kane's damper", "never", 0, 1e-14, 9)};
  one.swaps = {{0, 2}, {1, 2}};  // 0 and 1 exchanged, it ends about the same axis
  return one;
}

}  // namespace

const std::vector<Case>& torqueCases() {
  static const std::vector<Case> all = {lagrange("lagrange_slow", "3.22558044772"),
                                        lagrange("lagrange_fast", "17.55902924311"),
                                        libration(),
                                        dampedSphere(),
                                        worldTorque(),
                                        explorer()};
  return all;
}

}  // namespace poinsot::validation
