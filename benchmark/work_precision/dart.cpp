#include <dart/config.hpp>
#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/simulation/World.hpp>

#include <stdexcept>

#include "fixed_step_engine.h"

/** DART. */
namespace poinsot::work_precision {
namespace {

class World {
 public:
  explicit World(const Problem& problem)
      : problem_(problem), world_(dart::simulation::World::create()), skeleton_(dart::dynamics::Skeleton::create()) {
    world_->setGravity(Eigen::Vector3d::Zero());
    auto [joint, body] = skeleton_->createJointAndBodyNodePair<dart::dynamics::BallJoint>();
    joint_ = joint;
    body_ = body;
    const Eigen::Vector3d& m = problem.moments;
    body_->setInertia(dart::dynamics::Inertia(1, Eigen::Vector3d::Zero(), m.asDiagonal()));
    world_->addSkeleton(skeleton_);
  }

  void restart() {
    joint_->setPositions(dart::dynamics::BallJoint::convertToPositions(problem_.attitude.toRotationMatrix()));
    joint_->setVelocities(problem_.omega);
    joint_->setAccelerations(Eigen::Vector3d::Zero());
  }
  void prepare(double h) { world_->setTimeStep(h); }
  void step() {
    // Beyond it DART ends the process by an assertion.
    const double turn = joint_->getVelocities().norm() * world_->getTimeStep();
    if (!(turn < kMostTurn)) throw std::runtime_error("DART diverges");
    world_->step();
  }
  Answer answer(double t) const {
    const Eigen::Quaterniond attitude(body_->getTransform().linear());
    return {t, attitude, joint_->getVelocities()};
  }

 private:
  static constexpr double kMostTurn = 100;  // rad a step

  Problem problem_;
  std::shared_ptr<dart::simulation::World> world_;
  dart::dynamics::SkeletonPtr skeleton_;
  dart::dynamics::BallJoint* joint_;
  dart::dynamics::BodyNode* body_;
};

class Dart final : public Engine {
 public:
  Dart()
      : Engine("dart", "DART", DART_VERSION,
               "one body on a BallJoint, no gravity, World::step(): semi-implicit Euler, the only integrator it has") {}
  std::unique_ptr<Run> start(const Problem& problem, double step) const override {
    return std::make_unique<EngineRun<World>>(step, problem);
  }
};

}  // namespace

void addDart(Contestants& to) {
  to.push_back(std::make_unique<Dart>());
}

}  // namespace poinsot::work_precision
