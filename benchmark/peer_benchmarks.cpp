#include "peer_benchmarks.h"

#include <benchmark/benchmark.h>

#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include "regimes.h"

namespace poinsot::benchmarks {
namespace {

using Body = std::array<double, 7>;  // w, x, y, z of the attitude, then Ω

constexpr double kStep = 0.01;  // s; |Ω| is about 1 rad/s

/** q̇ = ½q(0, Ω) and Euler's equations, with coefficients computed once. */
class FreeBody {
 public:
  explicit FreeBody(const Eigen::Vector3d& moments)
      : a_((moments[1] - moments[2]) / moments[0]),
        b_((moments[2] - moments[0]) / moments[1]),
        c_((moments[0] - moments[1]) / moments[2]) {}

  void operator()(const Body& s, Body& rate, double) const {
    rate[0] = 0.5 * (-s[1] * s[4] - s[2] * s[5] - s[3] * s[6]);
    rate[1] = 0.5 * (s[0] * s[4] + s[2] * s[6] - s[3] * s[5]);
    rate[2] = 0.5 * (s[0] * s[5] + s[3] * s[4] - s[1] * s[6]);
    rate[3] = 0.5 * (s[0] * s[6] + s[1] * s[5] - s[2] * s[4]);
    rate[4] = a_ * s[5] * s[6];
    rate[5] = b_ * s[6] * s[4];
    rate[6] = c_ * s[4] * s[5];
  }

 private:
  double a_, b_, c_;
};

/** The same in the style of odeint's tutorial: a function that the solver calls through a pointer; the body is global.
 */
double a, b, c;

void freeBody(const Body& s, Body& rate, double) {
  rate[0] = 0.5 * (-s[1] * s[4] - s[2] * s[5] - s[3] * s[6]);
  rate[1] = 0.5 * (s[0] * s[4] + s[2] * s[6] - s[3] * s[5]);
  rate[2] = 0.5 * (s[0] * s[5] + s[3] * s[4] - s[1] * s[6]);
  rate[3] = 0.5 * (s[0] * s[6] + s[1] * s[5] - s[2] * s[4]);
  rate[4] = a * s[5] * s[6];
  rate[5] = b * s[6] * s[4];
  rate[6] = c * s[4] * s[5];
}

/** The solver in a loop that keeps the state. */
template <class System>
void steps(benchmark::State& state, const System& system) {
  const Start& start = regime("general").starts.front();
  boost::numeric::odeint::runge_kutta4<Body> solver;
  Body s = {start.attitude.w(), start.attitude.x(), start.attitude.y(), start.attitude.z(),
            start.omega[0],     start.omega[1],     start.omega[2]};
  double t = 0;
  for (auto _ : state) {
    solver.do_step(system, s, t, kStep);
    t += kStep;
    benchmark::DoNotOptimize(s);
  }
}

}  // namespace

void addPeers() {
  const Eigen::Vector3d& m = regime("general").starts.front().moments;
  benchmark::RegisterBenchmark("peer/odeint_rk4_step", steps<FreeBody>, FreeBody(m));
  a = (m[1] - m[2]) / m[0];
  b = (m[2] - m[0]) / m[1];
  c = (m[0] - m[1]) / m[2];
  benchmark::RegisterBenchmark("peer/odeint_rk4_step/function", steps<decltype(&freeBody)>, &freeBody);
}

}  // namespace poinsot::benchmarks
