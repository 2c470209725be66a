#include <ode/ode.h>

#include <stdexcept>

#include "fixed_step_engine.h"

/** The Open Dynamics Engine. */
namespace poinsot::work_precision {
namespace {

class World {
 public:
  World(const Problem& problem, bool finite_rotation)
      : problem_(problem), world_(dWorldCreate()), body_(dBodyCreate(world_)) {
    dWorldSetGravity(world_, 0, 0, 0);
    dMass mass;
    const Eigen::Vector3d& m = problem.moments;
    dMassSetParameters(&mass, 1, 0, 0, 0, m[0], m[1], m[2], 0, 0, 0);
    dBodySetMass(body_, &mass);
    dBodySetGyroscopicMode(body_, 1);
    dBodySetFiniteRotationMode(body_, finite_rotation ? 1 : 0);
    dBodySetAutoDisableFlag(body_, 0);
    dBodySetDamping(body_, 0, 0);
  }
  ~World() { dWorldDestroy(world_); }

  void restart() {
    const dQuaternion q = {problem_.attitude.w(), problem_.attitude.x(), problem_.attitude.y(), problem_.attitude.z()};
    dBodySetQuaternion(body_, q);
    const Eigen::Vector3d omega = problem_.attitude * problem_.omega;
    dBodySetAngularVel(body_, omega[0], omega[1], omega[2]);
  }
  void prepare(double h) { h_ = h; }
  void step() { dWorldStep(world_, h_); }
  Answer answer(double t) const {
    const dReal* q = dBodyGetQuaternion(body_);
    const dReal* w = dBodyGetAngularVel(body_);
    const Eigen::Quaterniond attitude(q[0], q[1], q[2], q[3]);
    return {t, attitude, attitude.conjugate() * Eigen::Vector3d(w[0], w[1], w[2])};
  }

 private:
  Problem problem_;
  dWorldID world_;
  dBodyID body_;
  double h_ = 0;
};

class Ode final : public Engine {
 public:
  explicit Ode(bool finite_rotation)
      : Engine(finite_rotation ? "ode_finite_rotation" : "ode", "ODE", POINSOT_ODE_VERSION,
               std::string("dWorldStep, dBodySetGyroscopicMode 1, dBodySetFiniteRotationMode ") +
                   (finite_rotation ? "1" : "0") + ", no damping, " + (sizeof(dReal) == 4 ? "single" : "double") +
                   " precision"),
        finite_rotation_(finite_rotation) {}
  std::unique_ptr<Run> start(const Problem& problem, double step) const override {
    return std::make_unique<EngineRun<World>>(step, problem, finite_rotation_);
  }

 private:
  bool finite_rotation_;
};

}  // namespace

void addOde(Contestants& to) {
  dInitODE2(0);
  to.push_back(std::make_unique<Ode>(false));
  to.push_back(std::make_unique<Ode>(true));
}

}  // namespace poinsot::work_precision
