#include <Simbody.h>

#include <algorithm>

#include "fixed_step_engine.h"

/** Simbody. */
namespace poinsot::work_precision {
namespace {

// CPodesIntegrator is left out: in Debian's Simbody 3.7 it ends the process by an assertion in its first step.
enum class Kind { merson, feldberg };

class SimbodyRun final : public Run {
 public:
  SimbodyRun(const Problem& problem, Kind kind, double accuracy) : problem_(problem), matter_(system_) {
    SimTK::Body::Rigid body(SimTK::MassProperties(
        1, SimTK::Vec3(0), SimTK::Inertia(problem.moments[0], problem.moments[1], problem.moments[2])));
    joint_ = SimTK::MobilizedBody::Ball(matter_.Ground(), SimTK::Transform(), body, SimTK::Transform());
    system_.setUseUniformBackground(true);
    start_ = system_.realizeTopology();
    const Eigen::Quaterniond& q = problem.attitude;
    joint_.setQToFitRotation(start_, SimTK::Rotation(SimTK::Quaternion(q.w(), q.x(), q.y(), q.z())));
    const Eigen::Vector3d omega = q * problem.omega;
    joint_.setUToFitAngularVelocity(start_, SimTK::Vec3(omega[0], omega[1], omega[2]));
    if (kind == Kind::merson) integrator_ = std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system_);
    if (kind == Kind::feldberg) integrator_ = std::make_unique<SimTK::RungeKuttaFeldbergIntegrator>(system_);
    integrator_->setAccuracy(accuracy);
  }

  Answer shot(double horizon, const Watch& watch, Effort& effort) override {
    begin(horizon);
    if (watch) integrator_->setReturnEveryInternalStep(true);
    while (integrator_->getTime() < horizon) {
      integrator_->stepTo(horizon);
      if (watch) watch(answer(integrator_->getTime()));
    }
    integrator_->setReturnEveryInternalStep(false);
    end(effort);
    return answer(horizon);
  }

  void ticks(double interval, std::int64_t count, Answer* out, Effort& effort) override {
    begin(static_cast<double>(count) * interval);
    for (std::int64_t i = 1; i <= count; ++i) {
      const double tick = static_cast<double>(i) * interval;
      while (integrator_->getTime() < tick) integrator_->stepTo(tick);
      out[i - 1] = answer(tick);
    }
    end(effort);
  }

 private:
  void begin(double horizon) {
    integrator_->setFinalTime(horizon);
    integrator_->initialize(start_);
    integrator_->resetAllStatistics();
  }
  void end(Effort& effort) const { effort.steps += integrator_->getNumStepsAttempted(); }
  Answer answer(double t) const {
    const SimTK::State& state = integrator_->getState();
    system_.realize(state, SimTK::Stage::Velocity);
    const SimTK::Quaternion q = joint_.getBodyRotation(state).convertRotationToQuaternion();
    const SimTK::Vec3 w = joint_.getBodyAngularVelocity(state);
    const Eigen::Quaterniond attitude(q[0], q[1], q[2], q[3]);
    return {t, attitude, attitude.conjugate() * Eigen::Vector3d(w[0], w[1], w[2])};
  }

  Problem problem_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::MobilizedBody::Ball joint_;
  SimTK::State start_;
  std::unique_ptr<SimTK::Integrator> integrator_;
};

class Simbody final : public Engine {
 public:
  Simbody(const char* name, const char* integrator, Kind kind)
      : Engine(
            std::string("simbody_") + name, "Simbody", versionOf(),
            std::string(integrator) + ", setAccuracy, one body on a MobilizedBody::Ball; ticks by its interpolation"),
        kind_(kind) {}
  Knob knob() const override { return Knob::tolerance; }
  std::unique_ptr<Run> start(const Problem& problem, double accuracy) const override {
    return std::make_unique<SimbodyRun>(problem, kind_, accuracy);
  }

 private:
  static std::string versionOf() {
    int major = 0, minor = 0, build = 0;
    SimTK_version_simbody(&major, &minor, &build);
    return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
  }
  Kind kind_;
};

}  // namespace

void addSimbody(Contestants& to) {
  to.push_back(std::make_unique<Simbody>("merson", "RungeKuttaMersonIntegrator", Kind::merson));
  to.push_back(std::make_unique<Simbody>("feldberg", "RungeKuttaFeldbergIntegrator", Kind::feldberg));
}

}  // namespace poinsot::work_precision
