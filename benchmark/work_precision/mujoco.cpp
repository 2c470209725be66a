#include <mujoco/mujoco.h>

#include <cstdio>
#include <stdexcept>

#include "fixed_step_engine.h"

/** MuJoCo. */
namespace poinsot::work_precision {
namespace {

/** One body on a ball joint, nothing else in the world. */
std::string xml(const Problem& problem, const char* integrator) {
  char text[1024];
  std::snprintf(text, sizeof text,
                "<mujoco><compiler boundmass='0' boundinertia='0' balanceinertia='false'/>"
                "<option gravity='0 0 0' integrator='%s'><flag contact='disable' constraint='disable'/></option>"
                "<worldbody><body><joint type='ball'/>"
                "<inertial pos='0 0 0' mass='1' diaginertia='%.17g %.17g %.17g'/></body></worldbody></mujoco>",
                integrator, problem.moments[0], problem.moments[1], problem.moments[2]);
  return text;
}

/** MuJoCo's warning since the last start; by default it would reset the body to rest and write a log file. */
std::string complaint;

void complain(const char* what) {
  complaint = what;
}

class World {
 public:
  World(const Problem& problem, const char* integrator) : problem_(problem) {
    const std::string text = xml(problem, integrator);
    auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "body.xml", static_cast<int>(text.size()));
    std::copy(text.begin(), text.end(), static_cast<char*>(files->filedata[0]));
    char error[500] = "";
    model_ = mj_loadXML("body.xml", files.get(), error, sizeof error);
    mj_deleteVFS(files.get());
    if (!model_) throw std::runtime_error(std::string("MuJoCo refuses the body: ") + error);
    data_ = mj_makeData(model_);
  }
  ~World() {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }

  void restart() {
    complaint.clear();
    mj_resetData(model_, data_);
    // The axes of the joint are those of the body. MuJoCo may list those of the inertia in another order, and converts
    // them itself.
    const double q[] = {problem_.attitude.w(), problem_.attitude.x(), problem_.attitude.y(), problem_.attitude.z()};
    std::copy(q, q + 4, data_->qpos);
    std::copy(problem_.omega.data(), problem_.omega.data() + 3, data_->qvel);
  }
  void prepare(double h) { model_->opt.timestep = h; }
  void step() {
    mj_step(model_, data_);
    if (!complaint.empty()) throw std::runtime_error("MuJoCo: " + complaint);
  }
  Answer answer(double t) const {
    const mjtNum *q = data_->qpos, *w = data_->qvel;
    return {t, Eigen::Quaterniond(q[0], q[1], q[2], q[3]), Eigen::Vector3d(w[0], w[1], w[2])};
  }

 private:
  Problem problem_;
  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
};

class Mujoco final : public Engine {
 public:
  Mujoco(const char* name, const char* integrator)
      : Engine(std::string("mujoco_") + name, "MuJoCo", mj_versionString(),
               std::string("integrator ") + integrator +
                   ", one body on a ball joint, no gravity, contacts and constraints off"),
        integrator_(integrator) {}
  std::unique_ptr<Run> start(const Problem& problem, double step) const override {
    return std::make_unique<EngineRun<World>>(step, problem, integrator_);
  }

 private:
  const char* integrator_;
};

}  // namespace

void addMujoco(Contestants& to) {
  mju_user_warning = complain;
  to.push_back(std::make_unique<Mujoco>("euler", "Euler"));
  to.push_back(std::make_unique<Mujoco>("implicit", "implicit"));
  to.push_back(std::make_unique<Mujoco>("rk4", "RK4"));
}

}  // namespace poinsot::work_precision
