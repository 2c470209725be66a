/**
 * What accuracy costs under torques: CPU time of Poinsot's methods and of Boost.odeint's steppers for one motion to
 * T = 100 s, set-up included, at equal error, in one run. Prints a Markdown table; exit 1 if in some line the cheapest
 * of Poinsot's methods costs more than the cheapest of odeint's.
 *
 * The error is the worst of four end times, of the attitude [rad] and of Omega, relative to |Omega|. The truth is
 * odeint's Fehlberg 7(8) in long double at a small step, so no method is judged by itself.
 */
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "poinsot/core/effect.h"
#include "poinsot/core/method.h"
#include "poinsot/core/no_convergence.h"
#include "poinsot/core/rotation.h"
#include "poinsot/cost/cpu_time.h"

namespace {

namespace odeint = boost::numeric::odeint;
using poinsot::Effect;

constexpr double kEnds[] = {100, 83, 61, 37};  // s; the first is timed
constexpr double kAccuracies[] = {1e-4, 1e-8, 1e-12};
constexpr int kRepetitions = 7;
constexpr double kNoLonger = 4;

template <class Number>
using State = std::array<Number, 7>;  // w x y z, Omega

/** The right-hand side as a user would write it for this torque alone. */
template <class Number, class Torque>
struct System {
  std::array<Number, 3> moments;
  Torque torque;

  void operator()(const State<Number>& s, State<Number>& rate, Number t) const {
    const Number w = s[0], x = s[1], y = s[2], z = s[3], a = s[4], b = s[5], c = s[6];
    const Number half = Number(0.5);
    rate[0] = half * (-x * a - y * b - z * c);
    rate[1] = half * (w * a + y * c - z * b);
    rate[2] = half * (w * b + z * a - x * c);
    rate[3] = half * (w * c + x * b - y * a);
    std::array<Number, 3> tau;
    torque(s, t, moments, tau);
    rate[4] = ((moments[1] - moments[2]) * b * c + tau[0]) / moments[0];
    rate[5] = ((moments[2] - moments[0]) * c * a + tau[1]) / moments[1];
    rate[6] = ((moments[0] - moments[1]) * a * b + tau[2]) / moments[2];
  }
};

/** R^T v of a quaternion that need not be quite unit. */
template <class Number>
std::array<Number, 3> back(const State<Number>& s, const std::array<Number, 3>& v) {
  const Number w = s[0], x = s[1], y = s[2], z = s[3];
  const Number n = 1 / (w * w + x * x + y * y + z * z);
  return {n * ((w * w + x * x - y * y - z * z) * v[0] + 2 * (x * y + w * z) * v[1] + 2 * (x * z - w * y) * v[2]),
          n * (2 * (x * y - w * z) * v[0] + (w * w - x * x + y * y - z * z) * v[1] + 2 * (y * z + w * x) * v[2]),
          n * (2 * (x * z + w * y) * v[0] + 2 * (y * z - w * x) * v[1] + (w * w - x * x - y * y + z * z) * v[2])};
}

struct Gravity {
  double weight;
  double lever[3];
  template <class Number>
  void operator()(const State<Number>& s, Number, const std::array<Number, 3>&, std::array<Number, 3>& tau) const {
    const auto f = back<Number>(s, {0, 0, Number(-weight)});
    tau = {lever[1] * f[2] - lever[2] * f[1], lever[2] * f[0] - lever[0] * f[2], lever[0] * f[1] - lever[1] * f[0]};
  }
};

struct Gradient {
  double rate;
  template <class Number>
  void operator()(const State<Number>& s, Number t, const std::array<Number, 3>& m, std::array<Number, 3>& tau) const {
    using std::cos;
    using std::sin;
    const auto u = back<Number>(s, {cos(Number(rate) * t), sin(Number(rate) * t), 0});
    const Number k = 3 * Number(rate) * Number(rate);
    tau = {k * (m[2] - m[1]) * u[1] * u[2], k * (m[0] - m[2]) * u[2] * u[0], k * (m[1] - m[0]) * u[0] * u[1]};
  }
};

struct Constant {
  double torque[3];
  template <class Number>
  void operator()(const State<Number>&, Number, const std::array<Number, 3>&, std::array<Number, 3>& tau) const {
    tau = {Number(torque[0]), Number(torque[1]), Number(torque[2])};
  }
};

struct Damping {
  double coefficient;
  template <class Number>
  void operator()(const State<Number>& s, Number, const std::array<Number, 3>&, std::array<Number, 3>& tau) const {
    for (int i = 0; i < 3; ++i) tau[i] = -Number(coefficient) * s[4 + i];
  }
};

struct Problem {
  const char* name;
  Eigen::Vector3d moments, omega;
  Eigen::Quaterniond attitude;
  std::vector<Effect> effects;
};

/** A solver with one setting. */
struct Contestant {
  std::string name;
  std::vector<double> knobs;  ///< from coarse to fine
  std::function<State<double>(double knob, double end)> run;
};

State<double> lost() {
  return {NAN, NAN, NAN, NAN, NAN, NAN, NAN};
}

template <class Number>
State<Number> startOf(const Problem& p) {
  const auto& q = p.attitude;
  return {q.w(), q.x(), q.y(), q.z(), p.omega[0], p.omega[1], p.omega[2]};
}

template <class Number, class Torque>
System<Number, Torque> systemOf(const Problem& p, const Torque& torque) {
  return {{p.moments[0], p.moments[1], p.moments[2]}, torque};
}

template <class Number, class Torque, class Stepper>
State<Number> fixedSteps(const Problem& p, const Torque& torque, Stepper stepper, double step, double end) {
  State<Number> s = startOf<Number>(p);
  const auto system = systemOf<Number>(p, torque);
  const long n = static_cast<long>(std::ceil(end / step));
  const Number h = Number(end) / Number(n);
  for (long i = 0; i < n; ++i) stepper.do_step(std::ref(system), s, Number(i) * h, h);
  return s;
}

template <class Torque, class Controlled>
State<double> adaptive(const Problem& p, const Torque& torque, Controlled stepper, double end) {
  State<double> s = startOf<double>(p);
  const auto system = systemOf<double>(p, torque);
  try {
    odeint::integrate_adaptive(stepper, std::ref(system), s, 0.0, end, 0.05);
  } catch (const std::exception&) {  // it finds no step
    return lost();
  }
  return s;
}

std::vector<double> ladder(double from, double to, double ratio) {
  std::vector<double> out;
  for (double x = from; x > to; x /= ratio) out.push_back(x);
  return out;
}

template <class Torque>
std::vector<Contestant> peers(const Problem& p, const Torque& torque) {
  using S = State<double>;
  const std::vector<double> steps = ladder(2, 5e-4, 1.25), tolerances = ladder(1e-1, 1e-16, 2);
  return {
      {"fehlberg78", tolerances,
       [=](double e, double end) {
         return adaptive(p, torque, odeint::make_controlled<odeint::runge_kutta_fehlberg78<S>>(e, e), end);
       }},
      {"bulirsch_stoer", tolerances,
       [=](double e, double end) { return adaptive(p, torque, odeint::bulirsch_stoer<S>(e, e), end); }},
      {"rk4", steps,
       [=](double h, double end) { return fixedSteps<double>(p, torque, odeint::runge_kutta4<S>(), h, end); }},
      {"fehlberg78, fixed", steps,
       [=](double h, double end) {
         return fixedSteps<double>(p, torque, odeint::runge_kutta_fehlberg78<S>(), h, end);
       }},
      {"adams_bashforth_moulton 8", steps,
       [=](double h, double end) {
         return fixedSteps<double>(p, torque, odeint::adams_bashforth_moulton<8, S>(), h, end);
       }},
      {"cash_karp54", tolerances,
       [=](double e, double end) {
         return adaptive(p, torque, odeint::make_controlled<odeint::runge_kutta_cash_karp54<S>>(e, e), end);
       }},
      {"dopri5", tolerances,
       [=](double e, double end) {
         return adaptive(p, torque, odeint::make_controlled<odeint::runge_kutta_dopri5<S>>(e, e), end);
       }},
  };
}

std::vector<Contestant> ours(const Problem& p) {
  std::vector<Contestant> out;
  const auto inertia = poinsot::PrincipalInertia::fromMoments(p.moments);
  for (const poinsot::Method& method : poinsot::torquedMethods()) {
    if (!poinsot::objectionTo(method, poinsot::sumOf(inertia, p.effects)).empty()) continue;
    out.push_back({method.name, ladder(4, 5e-4, 1.15), [=](double step, double end) {
                     const auto stepper = method.make(poinsot::sumOf(inertia, p.effects));
                     auto s = poinsot::RotationState::fromOmega(p.moments, p.attitude, p.omega);
                     const long n = static_cast<long>(std::ceil(end / step));
                     const double h = end / static_cast<double>(n);
                     try {
                       stepper->advance(s, 0, h, n);
                     } catch (const poinsot::NoConvergence&) {
                       return lost();
                     }
                     const auto& q = s.attitude;
                     const Eigen::Vector3d w = s.omegaPrincipal(p.moments);
                     return State<double>{q.w(), q.x(), q.y(), q.z(), w[0], w[1], w[2]};
                   }});
  }
  return out;
}

double errorOf(const State<double>& s, const State<double>& truth) {
  const Eigen::Quaterniond a(s[0], s[1], s[2], s[3]), b(truth[0], truth[1], truth[2], truth[3]);
  const Eigen::Vector3d v(s[4], s[5], s[6]), w(truth[4], truth[5], truth[6]);
  const double error = std::max(poinsot::angleBetween(a.normalized(), b.normalized()), (v - w).norm() / w.norm());
  return error == error ? error : HUGE_VAL;
}

double secondsOf(const Contestant& c, double knob) {
  double best = HUGE_VAL;
  volatile double sink = 0;
  for (int i = 0; i < kRepetitions; ++i) {
    const double begin = poinsot::cost::threadCpuTime();
    sink = sink + c.run(knob, kEnds[0])[0];
    best = std::min(best, poinsot::cost::threadCpuTime() - begin - poinsot::cost::clockCost());
  }
  return best;
}

struct Best {
  std::string name = "none";
  double seconds = HUGE_VAL;
};

/** The cheapest for each accuracy. */
std::vector<Best> cheapest(const std::vector<Contestant>& contestants, const std::vector<State<double>>& truth) {
  std::vector<Best> best(std::size(kAccuracies));
  for (const Contestant& c : contestants) {
    for (const double knob : c.knobs) {
      // A solver that has become this much more expensive than another does not win at higher accuracies.
      const double begin = poinsot::cost::threadCpuTime();
      double error = errorOf(c.run(knob, kEnds[0]), truth[0]);
      if (poinsot::cost::threadCpuTime() - begin > kNoLonger * best.back().seconds) break;
      for (std::size_t k = 1; k < truth.size() && error <= kAccuracies[0]; ++k) {
        error = std::max(error, errorOf(c.run(knob, kEnds[k]), truth[k]));
      }
      if (error > kAccuracies[0]) continue;
      // A shorter step may be cheaper: a step that is too long is first tried in vain and then cut into parts.
      const double seconds = secondsOf(c, knob);
      for (std::size_t k = 0; k < best.size() && error <= kAccuracies[k]; ++k) {
        if (seconds < best[k].seconds) best[k] = {c.name, seconds};
      }
    }
  }
  return best;
}

std::string format(const char* text, double value) {
  char out[64];
  std::snprintf(out, sizeof out, text, value);
  return out;
}

bool all_cheaper = true;

template <class Torque>
void compare(const Problem& p, const Torque& torque) {
  std::vector<State<double>> truth;
  for (const double end : kEnds) {
    const auto s = fixedSteps<long double>(p, torque, odeint::runge_kutta_fehlberg78<State<long double>, long double>(),
                                           4e-3, end);
    State<double> rounded;
    std::copy(s.begin(), s.end(), rounded.begin());
    truth.push_back(rounded);
  }
  const std::vector<Best> mine = cheapest(ours(p), truth), theirs = cheapest(peers(p, torque), truth);
  for (std::size_t k = 0; k < mine.size(); ++k) {
    const double ratio = mine[k].seconds / theirs[k].seconds;
    all_cheaper = all_cheaper && mine[k].seconds < HUGE_VAL && ratio <= 1;
    const std::string theirs_text = theirs[k].seconds < HUGE_VAL ? format("%.1f", 1e6 * theirs[k].seconds) : "";
    std::printf("| %s | %.0e | %s | %.1f | %s | %s | %s |\n", p.name, kAccuracies[k], mine[k].name.c_str(),
                1e6 * mine[k].seconds, theirs[k].name.c_str(), theirs_text.c_str(),
                theirs_text.empty() ? "" : format(ratio <= 1 ? "%.2f" : "**%.2f**", ratio).c_str());
  }
}

}  // namespace

int main() {
  using poinsot::Axes;
  const Eigen::Vector3d moments(1, 2, 3);
  const Eigen::Quaterniond attitude = Eigen::Quaterniond(0.8, 0.1, -0.5, 0.3).normalized();
  std::printf(
      "| torque | error | cheapest of Poinsot's | µs | cheapest of odeint's | µs | ratio "
      "|\n|---|---|---|---|---|---|---|\n");
  compare({"weak: gravity gradient, n = 0.02 of the spin",
           moments,
           {0.6, 0.5, 0.7},
           attitude,
           {poinsot::GravityGradient{0.02, {0, 0, 1}, {1, 0, 0}}}},
          Gradient{0.02});
  compare({"weak: constant in the body, 1e-3",
           moments,
           {0.6, 0.5, 0.7},
           attitude,
           {poinsot::ConstantTorque{Axes::body, {1e-3, -5e-4, 8e-4}}}},
          Constant{{1e-3, -5e-4, 8e-4}});
  compare({"weak: damping, half-life 200 s",
           moments,
           {0.6, 0.5, 0.7},
           attitude,
           {poinsot::ViscousDamping{{7e-3, 7e-3, 7e-3}}}},
          Damping{7e-3});
  compare({"weak: fast top",
           {0.02, 0.02, 0.006},
           {0, 0, 6},
           attitude,
           {poinsot::GravityTorque{1, {0, 0, -0.02}, {0, 0, 0.1}}}},
          Gravity{0.02, {0, 0, 0.1}});
  compare({"strong: constant in the body, spun up to 10 rad/s",
           moments,
           {0.1, -0.2, 0.3},
           attitude,
           {poinsot::ConstantTorque{Axes::body, {0.1, -0.05, 0.3}}}},
          Constant{{0.1, -0.05, 0.3}});
  compare({"strong: heavy symmetric top",
           {1, 1, 0.4},
           {0.3, 0, 4},
           attitude,
           {poinsot::GravityTorque{1, {0, 0, -2}, {0, 0, 0.5}}}},
          Gravity{2, {0, 0, 0.5}});
  compare({"strong: gravity gradient, n = the spin",
           moments,
           {0.3, 0.2, 0.4},
           attitude,
           {poinsot::GravityGradient{0.5, {0, 0, 1}, {1, 0, 0}}}},
          Gradient{0.5});
  return all_cheaper ? 0 : 1;
}
