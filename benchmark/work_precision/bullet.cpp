#include <btBulletDynamicsCommon.h>

#include "fixed_step_engine.h"

/** Bullet, each of its gyroscopic modes. */
namespace poinsot::work_precision {
namespace {

class World {
 public:
  World(const Problem& problem, int flags)
      : problem_(problem),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
        shape_(btScalar(1)) {
    world_.setGravity(btVector3(0, 0, 0));
    btRigidBody::btRigidBodyConstructionInfo info(
        1, nullptr, &shape_, btVector3(problem.moments[0], problem.moments[1], problem.moments[2]));
    body_ = std::make_unique<btRigidBody>(info);
    body_->setDamping(0, 0);
    body_->setActivationState(DISABLE_DEACTIVATION);
    body_->setFlags(flags);
    world_.addRigidBody(body_.get());
  }
  ~World() { world_.removeRigidBody(body_.get()); }

  void restart() {
    const Eigen::Quaterniond& q = problem_.attitude;
    btTransform start(btQuaternion(q.x(), q.y(), q.z(), q.w()), btVector3(0, 0, 0));
    body_->setCenterOfMassTransform(start);
    body_->setInterpolationWorldTransform(start);
    const Eigen::Vector3d omega = q * problem_.omega;
    body_->setLinearVelocity(btVector3(0, 0, 0));
    body_->setAngularVelocity(btVector3(omega[0], omega[1], omega[2]));
    body_->setInterpolationAngularVelocity(body_->getAngularVelocity());
    body_->updateInertiaTensor();
    body_->clearForces();
  }
  void prepare(double h) { h_ = static_cast<btScalar>(h); }
  void step() { world_.stepSimulation(h_, 0); }  // 0: one step of h, no interpolation
  Answer answer(double t) const {
    const btQuaternion q = body_->getOrientation();
    const btVector3& w = body_->getAngularVelocity();
    const Eigen::Quaterniond attitude(q.w(), q.x(), q.y(), q.z());
    return {t, attitude, attitude.conjugate() * Eigen::Vector3d(w.x(), w.y(), w.z())};
  }

 private:
  Problem problem_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  btSphereShape shape_;
  std::unique_ptr<btRigidBody> body_;
  btScalar h_ = 0;
};

class Bullet final : public Engine {
 public:
  Bullet(const char* mode, const char* flag, int flags)
      : Engine(std::string("bullet_") + mode, "Bullet",
               std::to_string(BT_BULLET_VERSION / 100) + "." + std::to_string(BT_BULLET_VERSION % 100),
               std::string("btDiscreteDynamicsWorld, one btRigidBody, ") + flag +
                   ", no damping, no sleeping, stepSimulation(h, 0); " + (sizeof(btScalar) == 4 ? "single" : "double") +
                   " precision"),
        flags_(flags) {}
  std::unique_ptr<Run> start(const Problem& problem, double step) const override {
    return std::make_unique<EngineRun<World>>(step, problem, flags_);
  }

 private:
  int flags_;
};

}  // namespace

void addBullet(Contestants& to) {
  to.push_back(std::make_unique<Bullet>("none", "no gyroscopic term", 0));
  to.push_back(
      std::make_unique<Bullet>("explicit", "BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT", BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT));
  to.push_back(std::make_unique<Bullet>("implicit_world", "BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD",
                                        BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD));
  to.push_back(std::make_unique<Bullet>("implicit_body", "BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY",
                                        BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY));
}

}  // namespace poinsot::work_precision
