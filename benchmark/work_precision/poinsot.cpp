#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contestant.h"
#include "poinsot/core/closed_form.h"
#include "poinsot/core/method.h"
#include "poinsot/core/motion.h"

/** Poinsot's own methods. */
namespace poinsot::work_precision {
namespace {

constexpr int kLooks = 2000;  // where more steps than this are watched, not each is shown

class StepperRun final : public Run {
 public:
  StepperRun(const Method& method, const Problem& problem, double step)
      : moments_(problem.moments),
        stepper_(method.make(problem.moments)),
        start_(RotationState::fromOmega(problem.moments, problem.attitude, problem.omega)),
        step_(step) {}

  Answer shot(double horizon, const Watch& watch, Effort& effort) override {
    const auto steps = static_cast<std::int64_t>(std::ceil(horizon / step_ * (1 - 1e-14)));
    const double step = horizon / static_cast<double>(steps);
    RotationState state = start_;
    if (!watch) {
      add(effort, steps, stepper_->advance(state, 0, step, steps));
      return answer(horizon, state);
    }
    const std::int64_t batch = std::max<std::int64_t>(1, steps / kLooks);
    for (std::int64_t n = 0; n < steps;) {
      const std::int64_t some = std::min(batch, steps - n);
      add(effort, some, stepper_->advance(state, 0, step, some));
      n += some;
      watch(answer(static_cast<double>(n) * step, state));
    }
    return answer(horizon, state);
  }

  void ticks(double interval, std::int64_t count, Answer* out, Effort& effort) override {
    const auto steps = static_cast<std::int64_t>(std::ceil(interval / step_ * (1 - 1e-14)));
    const double step = interval / static_cast<double>(steps);
    RotationState state = start_;
    for (std::int64_t i = 0; i < count; ++i) {
      add(effort, steps, stepper_->advance(state, 0, step, steps));
      out[i] = answer(static_cast<double>(i + 1) * interval, state);
    }
  }

 private:
  static void add(Effort& effort, std::int64_t steps, const Work& work) {
    effort.steps += steps;
    effort.evaluations = std::max<std::int64_t>(effort.evaluations, 0) + work.evaluations;
    effort.exponentials += work.exponentials;
  }
  Answer answer(double time, const RotationState& state) const {
    return {time, state.attitude, state.omegaPrincipal(moments_)};
  }

  Eigen::Vector3d moments_;
  std::unique_ptr<Stepper> stepper_;
  RotationState start_;
  double step_;
};

class OwnStepper final : public Contestant {
 public:
  explicit OwnStepper(const Method& method) : method_(method) {}
  std::string name() const override { return method_.name; }
  std::string package() const override { return "poinsot"; }
  std::string version() const override { return POINSOT_VERSION; }
  std::string settings() const override {
    return "order " + std::to_string(method_.order) +
           "; one call of Stepper::advance a run, or a tick, which it hits with equal steps";
  }
  Knob knob() const override { return Knob::step; }
  std::unique_ptr<Run> start(const Problem& problem, double step) const override {
    return std::make_unique<StepperRun>(method_, problem, step);
  }

 private:
  Method method_;
};

class ClosedFormRun final : public Run {
 public:
  explicit ClosedFormRun(const Problem& problem) : motion_(problem.moments, problem.attitude, problem.omega) {}

  Answer shot(double horizon, const Watch& watch, Effort& effort) override {
    for (int i = 1; watch && i < kLooks; ++i) watch(at(horizon * i / kLooks));
    ++effort.steps;
    effort.evaluations = 0;
    const Answer last = at(horizon);
    if (watch) watch(last);
    return last;
  }

  void ticks(double interval, std::int64_t count, Answer* out, Effort& effort) override {
    samples_.resize(count, Eigen::NoChange);
    motion_.sample(interval, interval, samples_);
    effort.steps += count;
    effort.evaluations = 0;
    const double *w = samples_.col(0).data(), *x = samples_.col(1).data(), *y = samples_.col(2).data(),
                 *z = samples_.col(3).data(), *a = samples_.col(4).data(), *b = samples_.col(5).data(),
                 *c = samples_.col(6).data();
    for (std::int64_t i = 0; i < count; ++i) {
      out[i].time = static_cast<double>(i + 1) * interval;
      out[i].time_rest = std::fma(static_cast<double>(i + 1), interval, -out[i].time);  // sample() takes times exactly
      out[i].attitude = Eigen::Quaterniond(w[i], x[i], y[i], z[i]);
      out[i].omega = Eigen::Vector3d(a[i], b[i], c[i]);
    }
  }

 private:
  Answer at(double t) const {
    const ClosedForm::State state = motion_.at(t);
    return {t, state.attitude, state.omega_principal};
  }

  ClosedForm motion_;
  ClosedForm::Samples samples_;
};

class OwnClosedForm final : public Contestant {
 public:
  std::string name() const override { return kClosedForm; }
  std::string package() const override { return "poinsot"; }
  std::string version() const override { return POINSOT_VERSION; }
  std::string settings() const override {
    return "set-up and at(T); ticks by sample(), copied into the same rows as everybody's";
  }
  Knob knob() const override { return Knob::none; }
  std::unique_ptr<Run> start(const Problem& problem, double) const override {
    return std::make_unique<ClosedFormRun>(problem);
  }
};

}  // namespace

void addPoinsot(Contestants& to) {
  to.push_back(std::make_unique<OwnClosedForm>());
  for (const Method& method : freeMethods()) to.push_back(std::make_unique<OwnStepper>(method));
}

}  // namespace poinsot::work_precision
