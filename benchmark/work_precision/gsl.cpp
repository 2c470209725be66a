#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_version.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "free_body_equations.h"

/** The GNU Scientific Library's odeiv2. */
namespace poinsot::work_precision {
namespace {

struct Counted {
  FreeBodyEquations equations;
  std::int64_t count = 0;
};

int rightHandSide(double, const double* s, double* rate, void* data) {
  auto& counted = *static_cast<Counted*>(data);
  ++counted.count;
  counted.equations(s, rate);
  return GSL_SUCCESS;
}

class GslRun final : public Run {
 public:
  /** @param tolerance positive for steps that GSL chooses, 0 for equal steps of `step`. */
  GslRun(const Problem& problem, const gsl_odeiv2_step_type* type, double step, double tolerance)
      : counted_{FreeBodyEquations(problem.moments)},
        start_(odeStart(problem)),
        first_step_(0.1 / std::max(problem.omega.norm(), 1e-300)),
        step_(step) {
    system_ = {rightHandSide, nullptr, 7, &counted_};
    driver_ = tolerance > 0 ? gsl_odeiv2_driver_alloc_y_new(&system_, type, first_step_, tolerance, tolerance)
                            : gsl_odeiv2_driver_alloc_y_new(&system_, type, step, 1, 0);
    if (!driver_) throw std::runtime_error("GSL gives no driver");
  }
  ~GslRun() override { gsl_odeiv2_driver_free(driver_); }

  Answer shot(double horizon, const Watch& watch, Effort& effort) override {
    begin();
    double t = 0;
    OdeState s = start_;
    std::int64_t steps = 0;
    if (step_ > 0) {
      steps = static_cast<std::int64_t>(std::ceil(horizon / step_ * (1 - 1e-14)));
      const double h = horizon / static_cast<double>(steps);
      if (watch) {
        for (std::int64_t i = 1; i <= steps; ++i) {
          check(gsl_odeiv2_driver_apply_fixed_step(driver_, &t, h, 1, s.data()));
          watch(odeAnswer(static_cast<double>(i) * h, s.data()));
        }
      } else {
        check(gsl_odeiv2_driver_apply_fixed_step(driver_, &t, h, steps, s.data()));
      }
    } else if (watch) {
      // What driver_apply does, step by step.
      double h = driver_->h;
      while (t < horizon) {
        check(gsl_odeiv2_evolve_apply(driver_->e, driver_->c, driver_->s, &system_, &t, horizon, &h, s.data()));
        watch(odeAnswer(t, s.data()));
      }
      steps = static_cast<std::int64_t>(driver_->e->count + driver_->e->failed_steps);
    } else {
      check(gsl_odeiv2_driver_apply(driver_, &t, horizon, s.data()));
      steps = static_cast<std::int64_t>(driver_->e->count + driver_->e->failed_steps);
    }
    end(effort, steps);
    return odeAnswer(horizon, s.data());
  }

  void ticks(double interval, std::int64_t count, Answer* out, Effort& effort) override {
    begin();
    double t = 0;
    OdeState s = start_;
    const auto each = step_ > 0 ? static_cast<std::int64_t>(std::ceil(interval / step_ * (1 - 1e-14))) : 0;
    for (std::int64_t i = 1; i <= count; ++i) {
      const double tick = static_cast<double>(i) * interval;
      if (each > 0) {
        check(gsl_odeiv2_driver_apply_fixed_step(driver_, &t, interval / static_cast<double>(each), each, s.data()));
      } else {
        check(gsl_odeiv2_driver_apply(driver_, &t, tick, s.data()));
      }
      out[i - 1] = odeAnswer(tick, s.data());
    }
    end(effort, each > 0 ? each * count : static_cast<std::int64_t>(driver_->e->count + driver_->e->failed_steps));
  }

 private:
  void begin() {
    gsl_odeiv2_driver_reset(driver_);
    gsl_odeiv2_driver_reset_hstart(driver_, step_ > 0 ? step_ : first_step_);
    counted_.count = 0;
  }
  void end(Effort& effort, std::int64_t steps) const {
    effort.steps += steps;
    effort.evaluations = std::max<std::int64_t>(effort.evaluations, 0) + counted_.count;
  }
  static void check(int status) {
    if (status != GSL_SUCCESS) throw std::runtime_error(gsl_strerror(status));
  }

  Counted counted_;
  OdeState start_;
  double first_step_, step_;
  gsl_odeiv2_system system_;
  gsl_odeiv2_driver* driver_;
};

class Gsl final : public Contestant {
 public:
  Gsl(const char* name, const gsl_odeiv2_step_type* type, Knob knob) : name_(name), type_(type), knob_(knob) {
    gsl_set_error_handler_off();
  }
  std::string name() const override { return "gsl_" + name_ + (knob_ == Knob::step ? "" : "_adaptive"); }
  std::string package() const override { return "GSL"; }
  std::string version() const override { return gsl_version; }
  std::string settings() const override {
    const std::string what = std::string("gsl_odeiv2_driver, step type ") + type_->name + ", (q, Omega); ";
    return what + (knob_ == Knob::step ? "apply_fixed_step, equal steps"
                                       : "absolute tolerance = relative; driver_apply to each tick");
  }
  Knob knob() const override { return knob_; }
  std::unique_ptr<Run> start(const Problem& problem, double setting) const override {
    const bool fixed = knob_ == Knob::step;
    return std::make_unique<GslRun>(problem, type_, fixed ? setting : 0, fixed ? 0 : setting);
  }

 private:
  std::string name_;
  const gsl_odeiv2_step_type* type_;
  Knob knob_;
};

}  // namespace

void addGsl(Contestants& to) {
  using Knob = Contestant::Knob;
  to.push_back(std::make_unique<Gsl>("rk4", gsl_odeiv2_step_rk4, Knob::step));
  to.push_back(std::make_unique<Gsl>("rkf45", gsl_odeiv2_step_rkf45, Knob::tolerance));
  to.push_back(std::make_unique<Gsl>("rkck", gsl_odeiv2_step_rkck, Knob::tolerance));
  to.push_back(std::make_unique<Gsl>("rk8pd", gsl_odeiv2_step_rk8pd, Knob::tolerance));
  to.push_back(std::make_unique<Gsl>("msadams", gsl_odeiv2_step_msadams, Knob::tolerance));
}

}  // namespace poinsot::work_precision
