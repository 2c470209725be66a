#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <boost/version.hpp>
#include <cmath>

#include "free_body_equations.h"

/** Boost.odeint. */
namespace poinsot::work_precision {
namespace {

namespace odeint = boost::numeric::odeint;

/** The right-hand side as odeint calls it; counts where `count` is set. */
struct System {
  const FreeBodyEquations* equations;
  std::int64_t* count;
  void operator()(const OdeState& s, OdeState& rate, double) const {
    ++*count;
    (*equations)(s.data(), rate.data());
  }
};

std::int64_t stepsTo(double horizon, double step) {
  return static_cast<std::int64_t>(std::ceil(horizon / step * (1 - 1e-14)));
}

/** The common part of the three ways to use odeint. */
class OdeintRun : public Run {
 protected:
  explicit OdeintRun(const Problem& problem) : equations_(problem.moments), start_(odeStart(problem)) {}
  System system() { return {&equations_, &count_}; }
  void begin() { count_ = 0; }
  void end(Effort& effort, std::int64_t steps) const {
    effort.steps += steps;
    effort.evaluations = std::max<std::int64_t>(effort.evaluations, 0) + count_;
  }

  FreeBodyEquations equations_;
  OdeState start_;
  std::int64_t count_ = 0;
};

template <class Solver>
class FixedRun final : public OdeintRun {
 public:
  FixedRun(const Problem& problem, double step) : OdeintRun(problem), step_(step) {}

  Answer shot(double horizon, const Watch& watch, Effort& effort) override {
    const std::int64_t steps = stepsTo(horizon, step_);
    const double h = horizon / static_cast<double>(steps);
    begin();
    Solver solver;
    OdeState s = start_;
    if (watch) {
      for (std::int64_t i = 0; i < steps; ++i) {
        solver.do_step(system(), s, static_cast<double>(i) * h, h);
        watch(odeAnswer(static_cast<double>(i + 1) * h, s.data()));
      }
    } else {
      for (std::int64_t i = 0; i < steps; ++i) solver.do_step(system(), s, static_cast<double>(i) * h, h);
    }
    end(effort, steps);
    return odeAnswer(horizon, s.data());
  }

  void ticks(double interval, std::int64_t count, Answer* out, Effort& effort) override {
    const std::int64_t steps = stepsTo(interval, step_);
    const double h = interval / static_cast<double>(steps);
    begin();
    Solver solver;
    OdeState s = start_;
    for (std::int64_t i = 0; i < count; ++i) {
      for (std::int64_t k = 0; k < steps; ++k) solver.do_step(system(), s, static_cast<double>(i * steps + k) * h, h);
      out[i] = odeAnswer(static_cast<double>(i + 1) * interval, s.data());
    }
    end(effort, steps * count);
  }

 private:
  double step_;
};

/** Controlled steps, with dense output if the solver has it, otherwise with steps that end at the ticks. */
template <class Controlled, class Dense>
class AdaptiveRun final : public OdeintRun {
 public:
  AdaptiveRun(const Problem& problem, double tolerance) : OdeintRun(problem), tolerance_(tolerance) {
    first_step_ = 0.1 / std::max(problem.omega.norm(), 1e-300);
  }

  Answer shot(double horizon, const Watch& watch, Effort& effort) override {
    begin();
    Controlled solver = Controlled::make(tolerance_);
    OdeState s = start_;
    double t = 0, h = std::min(first_step_, horizon);
    std::int64_t steps = 0;
    while (t < horizon) {
      h = std::min(h, horizon - t);
      const double left = horizon - t;
      const bool last = h == left;
      ++steps;
      if (solver.stepper.try_step(system(), s, t, h) != odeint::success) continue;
      if (last) t = horizon;
      if (watch) watch(odeAnswer(t, s.data()));
    }
    end(effort, steps);
    return odeAnswer(horizon, s.data());
  }

  void ticks(double interval, std::int64_t count, Answer* out, Effort& effort) override {
    begin();
    std::int64_t steps = 0;
    if constexpr (!std::is_void_v<Dense>) {
      Dense dense = Dense::make(tolerance_);
      dense.stepper.initialize(start_, 0.0, std::min(first_step_, interval * static_cast<double>(count)));
      OdeState s;
      std::int64_t i = 0;
      while (i < count) {
        const auto until = dense.stepper.do_step(system());
        ++steps;
        for (; i < count; ++i) {
          const double t = static_cast<double>(i + 1) * interval;
          if (t > until.second) break;
          dense.stepper.calc_state(t, s);
          out[i] = odeAnswer(t, s.data());
        }
      }
    } else {
      Controlled solver = Controlled::make(tolerance_);
      OdeState s = start_;
      double t = 0, free = std::min(first_step_, interval);  // the step that the solver would take
      for (std::int64_t i = 0; i < count; ++i) {
        const double tick = static_cast<double>(i + 1) * interval;
        while (t < tick) {
          double h = std::min(free, tick - t);
          const bool cut = h < free, last = h == tick - t;
          ++steps;
          const bool good = solver.stepper.try_step(system(), s, t, h) == odeint::success;
          if (!good || !cut || h > free) free = h;
          if (good && last) t = tick;
        }
        out[i] = odeAnswer(tick, s.data());
      }
    }
    end(effort, steps);
  }

 private:
  double tolerance_, first_step_;
};

template <class Error>
struct ControlledOf {
  using Stepper = typename odeint::result_of::make_controlled<Error>::type;
  Stepper stepper;
  static ControlledOf make(double tolerance) { return {odeint::make_controlled<Error>(tolerance, tolerance)}; }
};

template <class Error>
struct DenseOf {
  using Stepper = typename odeint::result_of::make_dense_output<Error>::type;
  Stepper stepper;
  static DenseOf make(double tolerance) { return {odeint::make_dense_output<Error>(tolerance, tolerance)}; }
};

struct BulirschStoer {
  odeint::bulirsch_stoer<OdeState> stepper;
  static BulirschStoer make(double tolerance) { return {odeint::bulirsch_stoer<OdeState>(tolerance, tolerance)}; }
};

struct BulirschStoerDense {
  odeint::bulirsch_stoer_dense_out<OdeState> stepper;
  static BulirschStoerDense make(double tolerance) {
    return {odeint::bulirsch_stoer_dense_out<OdeState>(tolerance, tolerance)};
  }
};

template <class RunType>
class Odeint final : public Contestant {
 public:
  Odeint(std::string name, Knob knob, std::string settings)
      : name_("odeint_" + std::move(name)), knob_(knob), settings_(std::move(settings)) {}
  std::string name() const override { return name_; }
  std::string package() const override { return "Boost.odeint"; }
  std::string version() const override {
    std::string version = BOOST_LIB_VERSION;
    std::replace(version.begin(), version.end(), '_', '.');
    return version;
  }
  std::string settings() const override { return settings_; }
  Knob knob() const override { return knob_; }
  std::unique_ptr<Run> start(const Problem& problem, double setting) const override {
    return std::make_unique<RunType>(problem, setting);
  }

 private:
  std::string name_;
  Knob knob_;
  std::string settings_;
};

template <class Solver>
void addFixed(Contestants& to, const char* name, const char* solver) {
  to.push_back(std::make_unique<Odeint<FixedRun<Solver>>>(
      name, Contestant::Knob::step,
      std::string(solver) + " on std::array<double, 7> (q, Omega), do_step in a loop, equal steps"));
}

template <class Controlled, class Dense>
void addAdaptive(Contestants& to, const char* name, const char* solver, const char* ticks) {
  to.push_back(std::make_unique<Odeint<AdaptiveRun<Controlled, Dense>>>(
      name, Contestant::Knob::tolerance,
      std::string(solver) + " on std::array<double, 7> (q, Omega), absolute tolerance = relative; " + ticks));
}

}  // namespace

void addOdeint(Contestants& to) {
  using Dopri5 = odeint::runge_kutta_dopri5<OdeState>;
  using Fehlberg78 = odeint::runge_kutta_fehlberg78<OdeState>;
  using CashKarp54 = odeint::runge_kutta_cash_karp54<OdeState>;
  addFixed<odeint::runge_kutta4<OdeState>>(to, "rk4", "runge_kutta4");
  addFixed<Dopri5>(to, "dopri5", "runge_kutta_dopri5");
  addFixed<Fehlberg78>(to, "fehlberg78", "runge_kutta_fehlberg78");
  addFixed<odeint::adams_bashforth_moulton<8, OdeState>>(to, "adams_bashforth_moulton8",
                                                         "adams_bashforth_moulton<8>, begun by runge_kutta4");
  addAdaptive<ControlledOf<Dopri5>, DenseOf<Dopri5>>(to, "dopri5_adaptive", "controlled runge_kutta_dopri5",
                                                     "ticks by its dense output");
  addAdaptive<ControlledOf<CashKarp54>, void>(to, "cash_karp54_adaptive", "controlled runge_kutta_cash_karp54",
                                              "steps cut at the ticks");
  addAdaptive<ControlledOf<Fehlberg78>, void>(to, "fehlberg78_adaptive", "controlled runge_kutta_fehlberg78",
                                              "steps cut at the ticks");
  addAdaptive<BulirschStoer, BulirschStoerDense>(to, "bulirsch_stoer", "bulirsch_stoer", "ticks by its dense output");
}

}  // namespace poinsot::work_precision
