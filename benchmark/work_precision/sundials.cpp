#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <stdexcept>

#include "free_body_equations.h"

/** SUNDIALS: CVODE's Adams methods and ARKODE's explicit Runge–Kutta methods. */
namespace poinsot::work_precision {
namespace {

constexpr long kMostSteps = 100000000;  // the default, 500, is too few for one call

int rightHandSide(realtype, N_Vector s, N_Vector rate, void* data) {
  (*static_cast<const FreeBodyEquations*>(data))(N_VGetArrayPointer(s), N_VGetArrayPointer(rate));
  return 0;
}

void check(int status, const char* what) {
  if (status < 0) throw std::runtime_error(std::string(what) + " returns " + std::to_string(status));
}

/** A vector, and the context that all functions of SUNDIALS need. */
class SundialsRun : public Run {
 public:
  ~SundialsRun() override {
    N_VDestroy(s_);
    SUNContext_Free(&context_);
  }

  Answer shot(double horizon, const Watch& watch, Effort& effort) override {
    restart();
    double t = 0;
    stopAt(horizon);
    if (watch) {
      while (t < horizon) {
        advance(horizon, &t, true);
        watch(odeAnswer(t, N_VGetArrayPointer(s_)));
      }
    } else {
      advance(horizon, &t, false);
    }
    tell(effort);
    return odeAnswer(horizon, N_VGetArrayPointer(s_));
  }

  void ticks(double interval, std::int64_t count, Answer* out, Effort& effort) override {
    restart();
    stopAt(static_cast<double>(count) * interval);
    double t = 0;
    for (std::int64_t i = 1; i <= count; ++i) {
      const double tick = static_cast<double>(i) * interval;
      advance(tick, &t, false);  // steps over it and interpolates
      out[i - 1] = odeAnswer(tick, N_VGetArrayPointer(s_));
    }
    tell(effort);
  }

 protected:
  explicit SundialsRun(const Problem& problem) : equations_(problem.moments), start_(odeStart(problem)) {
    SUNContext_Create(nullptr, &context_);
    s_ = N_VNew_Serial(7, context_);
    putStart();
  }
  void putStart() { std::copy(start_.begin(), start_.end(), N_VGetArrayPointer(s_)); }

  virtual void restart() = 0;
  virtual void stopAt(double t) = 0;
  virtual void advance(double until, double* t, bool one_step) = 0;
  virtual void tell(Effort& effort) = 0;

  FreeBodyEquations equations_;
  OdeState start_;
  SUNContext context_ = nullptr;
  N_Vector s_ = nullptr;
};

class CvodeRun final : public SundialsRun {
 public:
  CvodeRun(const Problem& problem, double tolerance) : SundialsRun(problem) {
    memory_ = CVodeCreate(CV_ADAMS, context_);
    check(CVodeInit(memory_, rightHandSide, 0, s_), "CVodeInit");
    check(CVodeSStolerances(memory_, tolerance, tolerance), "CVodeSStolerances");
    check(CVodeSetUserData(memory_, &equations_), "CVodeSetUserData");
    check(CVodeSetMaxNumSteps(memory_, kMostSteps), "CVodeSetMaxNumSteps");
    solver_ = SUNNonlinSol_FixedPoint(s_, 0, context_);
    check(CVodeSetNonlinearSolver(memory_, solver_), "CVodeSetNonlinearSolver");
  }
  ~CvodeRun() override {
    CVodeFree(&memory_);
    SUNNonlinSolFree(solver_);
  }

 private:
  void restart() override {
    putStart();
    check(CVodeReInit(memory_, 0, s_), "CVodeReInit");
  }
  void stopAt(double t) override { check(CVodeSetStopTime(memory_, t), "CVodeSetStopTime"); }
  void advance(double until, double* t, bool one_step) override {
    check(CVode(memory_, until, s_, t, one_step ? CV_ONE_STEP : CV_NORMAL), "CVode");
  }
  void tell(Effort& effort) override {
    long steps = 0, evaluations = 0;
    CVodeGetNumSteps(memory_, &steps);
    CVodeGetNumRhsEvals(memory_, &evaluations);
    effort.steps += steps;
    effort.evaluations = std::max<std::int64_t>(effort.evaluations, 0) + evaluations;
  }

  void* memory_;
  SUNNonlinearSolver solver_;
};

class ErkRun final : public SundialsRun {
 public:
  ErkRun(const Problem& problem, double tolerance, int order) : SundialsRun(problem) {
    memory_ = ERKStepCreate(rightHandSide, 0, s_, context_);
    check(ERKStepSStolerances(memory_, tolerance, tolerance), "ERKStepSStolerances");
    check(ERKStepSetOrder(memory_, order), "ERKStepSetOrder");
    check(ERKStepSetUserData(memory_, &equations_), "ERKStepSetUserData");
    check(ERKStepSetMaxNumSteps(memory_, kMostSteps), "ERKStepSetMaxNumSteps");
  }
  ~ErkRun() override { ERKStepFree(&memory_); }

  /** Its interpolant is of lower order than its steps, so the steps end at the ticks. */
  void ticks(double interval, std::int64_t count, Answer* out, Effort& effort) override {
    restart();
    double t = 0;
    for (std::int64_t i = 1; i <= count; ++i) {
      const double tick = static_cast<double>(i) * interval;
      stopAt(tick);
      advance(tick, &t, false);
      out[i - 1] = odeAnswer(tick, N_VGetArrayPointer(s_));
    }
    tell(effort);
  }

 private:
  void restart() override {
    putStart();
    check(ERKStepReInit(memory_, rightHandSide, 0, s_), "ERKStepReInit");
  }
  void stopAt(double t) override { check(ERKStepSetStopTime(memory_, t), "ERKStepSetStopTime"); }
  void advance(double until, double* t, bool one_step) override {
    check(ERKStepEvolve(memory_, until, s_, t, one_step ? ARK_ONE_STEP : ARK_NORMAL), "ERKStepEvolve");
  }
  void tell(Effort& effort) override {
    long attempts = 0, evaluations = 0;
    ERKStepGetNumStepAttempts(memory_, &attempts);
    ERKStepGetNumRhsEvals(memory_, &evaluations);
    effort.steps += attempts;
    effort.evaluations = std::max<std::int64_t>(effort.evaluations, 0) + evaluations;
  }

  void* memory_;
};

class Sundials final : public Contestant {
 public:
  /** @param order of ARKODE's method, 0 for CVODE. */
  explicit Sundials(int order) : order_(order) {}
  std::string name() const override {
    return order_ ? "sundials_erk" + std::to_string(order_) : "sundials_cvode_adams";
  }
  std::string package() const override { return "SUNDIALS"; }
  std::string version() const override { return SUNDIALS_VERSION; }
  std::string settings() const override {
    if (order_) {
      return "ARKODE ERKStep of order " + std::to_string(order_) +
             ", serial vector (q, Omega), absolute tolerance = relative; steps end at the ticks";
    }
    return "CVODE CV_ADAMS with SUNNonlinSol_FixedPoint, serial vector (q, Omega), absolute tolerance = relative; "
           "ticks by "
           "its interpolation";
  }
  Knob knob() const override { return Knob::tolerance; }
  std::unique_ptr<Run> start(const Problem& problem, double tolerance) const override {
    if (order_) return std::make_unique<ErkRun>(problem, tolerance, order_);
    return std::make_unique<CvodeRun>(problem, tolerance);
  }

 private:
  int order_;
};

}  // namespace

void addSundials(Contestants& to) {
  to.push_back(std::make_unique<Sundials>(0));
  for (const int order : {4, 5, 8}) to.push_back(std::make_unique<Sundials>(order));
}

}  // namespace poinsot::work_precision
