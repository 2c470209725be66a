// Uses all of Poinsot that has values of its own and prints every bit of what comes back: whatever the flags that this
// is compiled with, the output is the same. It computes nothing itself.
#include <cstddef>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "poinsot/core/assembly.h"
#include "poinsot/core/closed_form.h"
#include "poinsot/core/effect.h"
#include "poinsot/core/inertia.h"
#include "poinsot/core/invariants.h"
#include "poinsot/core/method.h"
#include "poinsot/core/motion.h"
#include "poinsot/core/no_convergence.h"
#include "poinsot/core/rotation.h"
#include "poinsot/core/rotation_state.h"
#include "poinsot/core/step_limits.h"
#include "poinsot/core/stepper_trajectory.h"
#include "poinsot/core/torques.h"

namespace {

using namespace poinsot;

void print(const char* what, double value) {
  std::printf("%s %a\n", what, value);
}
template <class Derived>
void print(const char* what, const Eigen::DenseBase<Derived>& values) {
  std::printf("%s", what);
  for (Eigen::Index j = 0; j < values.cols(); ++j) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) std::printf(" %a", static_cast<double>(values.derived()(i, j)));
  }
  std::printf("\n");
}
template <class Derived>
void print(const char* what, const Eigen::QuaternionBase<Derived>& q) {
  print(what, q.coeffs());
}

void print(const Invariants& invariants) {
  print("E", invariants.kinetic_energy);
  print("F", invariants.momentum_squared);
  print("L", invariants.momentum_world);
}

void print(const MotionState& state) {
  print("t", state.time);
  print("attitude", state.attitude);
  print("omega_body", state.omega_body);
  print("omega_world", state.omega_world);
  print("momentum_world", state.momentum_world);
  print("position", state.position);
  print("velocity", state.velocity);
  print("torque_world", state.torque_world);
  print("slug_omega", state.slug_omega);
  print(state.invariants());
}

void print(const RotationState& state) {
  print("attitude", state.attitude);
  print("momentum_principal", state.momentum_principal);
  print("attitude_rest", state.attitude_rest);
  print("momentum_rest", state.momentum_rest);
  print("kept_momentum", state.kept_momentum);
  print("kept_inverse_square", state.kept_inverse_square);
  print("kept_energy_gaps", state.kept_energy_gaps);
  print("momentum_world", state.momentumWorld());
}

void print(const PrincipalInertia& inertia) {
  print("moments", inertia.moments());
  print("axes", inertia.axes());
  print("tensor", inertia.tensor());
}

void print(const Assembly& assembly) {
  print("mass", assembly.mass());
  print("tensor", assembly.inertiaTensor());
  print("radius", assembly.boundingRadius());
  for (const Solid& solid : assembly.parts()) {
    print("size", solid.size);
    print("centre", solid.centre);
    print("orientation", solid.orientation);
    print("volume", solid.volume());
    print("inertia", solid.inertiaTensor());
  }
}

template <class Type>
void printLayout(const char* name) {
  static_assert(alignof(Type) <= alignof(std::max_align_t), "plain alignment");
  std::printf("%s size %zu alignment %zu\n", name, sizeof(Type), alignof(Type));
}

/** Members that begin at an odd place, as a user's struct has them. */
struct Kept {
  char name;
  std::optional<MotionSetup> setup;
  MotionState state;
  char mark;
  std::optional<ClosedForm::State> exact;
  RotationState rotation;
  std::optional<Solid> solid;
};

void printLayouts() {
  printLayout<Quaternion>("Quaternion");
  printLayout<Vector4>("Vector4");
  printLayout<Solid>("Solid");
  printLayout<Assembly>("Assembly");
  printLayout<ClosedForm>("ClosedForm");
  printLayout<ClosedForm::State>("ClosedForm::State");
  printLayout<PrincipalInertia>("PrincipalInertia");
  printLayout<Invariants>("Invariants");
  printLayout<MotionSetup>("MotionSetup");
  printLayout<MotionState>("MotionState");
  printLayout<Motion>("Motion");
  printLayout<RotationState>("RotationState");
  printLayout<Torques>("Torques");
  printLayout<Torques::Field>("Torques::Field");
  printLayout<Torques::Gradient>("Torques::Gradient");
  printLayout<Effect>("Effect");
  printLayout<Translation>("Translation");
  printLayout<StepperTrajectory>("StepperTrajectory");
  printLayout<StepJudgement>("StepJudgement");
  printLayout<Kept>("Kept");
}

Eigen::Matrix3d someTensor() {
  Eigen::Matrix3d tensor;
  tensor << 2, 0.3, -0.1, 0.3, 3, 0.2, -0.1, 0.2, 4;
  return tensor;
}

MotionSetup setupOf(const std::string& method, std::optional<double> step, const PrincipalInertia& inertia) {
  MotionSetup setup;
  setup.inertia = inertia;
  setup.attitude = Eigen::Quaterniond(0.5, -0.5, 0.1, 0.7);  // Eigen's own type goes in and comes out
  setup.omega_body = {0.01, 4, 0.01};
  setup.method = method;
  setup.step = step;
  return setup;
}

std::vector<MotionSetup> setups() {
  const PrincipalInertia diagonal = PrincipalInertia::fromMoments({1, 2, 3});
  const PrincipalInertia tensor = PrincipalInertia::fromTensor(someTensor());
  std::vector<MotionSetup> out;  // not reserved: it moves what it holds as it grows
  out.push_back(setupOf(kClosedForm, {}, diagonal));
  out.push_back(setupOf(kClosedForm, {}, tensor));
  out.back().translation = Translation{{1, 2, 3}, {0.1, 0.2, 0.3}, {0, 0, -9.80665}};
  for (const Method& method : freeMethods()) {
    out.push_back(setupOf(method.name, 0.01, &method == &freeMethods().front() ? tensor : diagonal));
  }
  const std::vector<Effect> conservative = {GravityTorque{0.7, {0, 0, -9.80665}, {0.01, 0.02, 0.03}},
                                            ConstantTorque{Axes::world, {0.1, 0.2, 0.3}},
                                            GravityGradient{0.3, {0, 0, 1}, {1, 0, 0}}};
  std::vector<Effect> all = conservative;
  all.push_back(ViscousDamping{{0.01, 0.02, 0.03}});
  all.push_back(InternalDissipation{0.2, 0.1});
  all.push_back(TorqueSchedule{{{0.5, 1.25, Axes::body, {0.3, 0, 0.1}}}});
  for (const Method& method : torquedMethods()) {
    out.push_back(setupOf(method.name, 0.01, tensor));
    out.back().effects = method.takes_damping ? all : conservative;
  }
  return out;
}

void printMotions() {
  std::vector<Motion> motions;
  std::vector<Kept> kept;
  for (const MotionSetup& setup : setups()) {
    motions.emplace_back(setup);
    Kept one = {};
    one.setup = setup;
    one.state = motions.back().at(0.377);
    kept.push_back(one);
  }
  const std::vector<Motion> copies = motions;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    Kept& one = kept[i];
    std::printf("motion %zu: %s\n", i, one.setup->method.c_str());
    print(one.setup->inertia);
    print("given", one.setup->attitude);
    print(one.state);
    for (const double t : {-1.003, 0.0, 2.5, 50.0}) {
      one.state = motions[i].at(t);
      print(one.state);
      const Eigen::Quaterniond attitude = one.state.attitude;
      print("attitude", attitude);
      print("error", motions[i].attitudeError(one.state));
    }
    Motion copy = copies[i];
    print(copy.at(1));
    if (const Torques* torques = copy.torques()) {
      print("torque", torques->at(0.75, torques->constant(torques->intervalAt(0.75)), Eigen::Quaterniond(0, 1, 0, 0),
                                  {1, 2, 3}, {3, 2, 1}));
      print("slug", torques->slugAcceleration({1, 2, 3}, {3, 2, 1}));
      print("impulse", torques->impulseWorld(2));
      for (const Torques::Field& field : torques->fields()) print("field", field.map);
      if (torques->gradient()) print("radial", torques->gradient()->radialAt(3));
    }
    if (const ClosedForm* exact = copy.closedForm()) one.exact = exact->at(17);
    if (one.exact) print("exact", one.exact->attitude);
  }
}

void printClosedForms() {
  std::vector<ClosedForm> bodies;
  bodies.emplace_back(Eigen::Vector3d(1, 2, 3), Eigen::Quaterniond(1, 0, 0, 0), Eigen::Vector3d(0.01, 4, 0.01));
  bodies.emplace_back(Eigen::Vector3d(3, 1, 2), Eigen::Quaterniond(1, 2, 3, 4), Eigen::Vector3d(0.1, 2, -1));
  bodies.emplace_back(Eigen::Vector3d(1, 1e-25, 3), Quaternion(1, 2, 3, 4), Eigen::Vector3d(1e-150, 2, 1));  // wide
  bodies.emplace_back(Eigen::Vector3d(1, 1, 1), Quaternion(0, 0, 0, 1), Eigen::Vector3d::Zero());
  for (const ClosedForm& body : bodies) {
    for (const double t : {-3.5, 0.0, 50.0, 1e9}) {
      const ClosedForm::State state = body.at(t);
      print("attitude", state.attitude);
      print("omega", state.omega_principal);
    }
    // A table of its own, released here; a part of another; plain memory.
    ClosedForm::Samples table = body.sample(1, 0.37, 100);
    print("table", table);
    table = body.sample(-1, 0.1, 3);
    print("table", table);
    Eigen::Matrix<double, Eigen::Dynamic, 9> larger = Eigen::Matrix<double, Eigen::Dynamic, 9>::Zero(41, 9);
    body.sample(-2, 0.21, larger.block<37, 7>(3, 1));
    print("larger", larger);
    std::vector<double> plain(7 * 11);
    double* columns[7];
    for (int i = 0; i < 7; ++i) columns[i] = plain.data() + 11 * i;
    body.sample(0.3, 0.01, 11, columns);
    for (const double value : plain) print("plain", value);
    print("period", body.period());
    print("montgomery", body.montgomeryAngle());
    print("precession", body.precessionRate());
    print("separatrix", body.separatrixDistance());
    print("flip", body.timeToNextFlip(0.5));
  }
}

void printAssemblies() {
  std::vector<Solid> solids;
  for (int i = 0; i < 7; ++i) {
    Solid solid;
    solid.type = i % 2 ? SolidType::box : SolidType::cylinder;
    solid.size = {0.1 + i, 0.2, 0.3};
    solid.mass = 1 + i;
    solid.centre = {0.3, 0.1 * i, -0.2};
    solid.orientation = Eigen::Quaterniond(0.5, 0.5, i % 2 ? 0.5 : -0.5, 0.5);
    solids.push_back(solid);
  }
  const Assembly assembly(solids);
  print(assembly);
  print(PrincipalInertia::fromTensor(assembly.inertiaTensor()));
  std::vector<Assembly> shapes;
  shapes.push_back(shapes::wingnut(0.1, 0.2, {0.3, 0.05, 0.2}, 0.4, 2));
  shapes.push_back(shapes::lShape(1, 2, 0.1, 3));
  shapes.push_back(shapes::equivalentBox({1, 2, 2.5}, Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5)));
  for (const Assembly& shape : shapes) print(shape);
}

void printSteppers() {
  const Eigen::Vector3d moments(1, 2, 3);
  std::vector<RotationState> states(3,
                                    RotationState::fromOmega(moments, Eigen::Quaterniond(1, 0, 0, 0), {0.1, 2, 0.3}));
  const std::unique_ptr<Stepper> stepper = findMethod("dmv6")->make(moments);
  for (RotationState& state : states) stepper->advance(state, 0, 0.01, 100);
  for (const RotationState& state : states) print(state);
  print(invariantsOf(moments, states.back()));
  print("drift", momentumDrift(invariantsOf(moments, states.back()), invariantsOf(moments, states.front())));

  std::vector<RotationState> torqued(3);
  const Torques torques = sumOf(PrincipalInertia::fromMoments(moments), {ConstantTorque{Axes::body, {1, 2, 3}}});
  for (RotationState& state : torqued) {
    state = states.front();
    findMethod("taylor12")->make(torques)->advanceFrom(state, 0, 0.1);
    print(state);
  }
  StepperTrajectory trajectory({findMethod("rk4")->make(moments)}, states.front(), 0.01);
  print(trajectory.at(1000));
  print(trajectory.at(500));
  const StepJudgement judgement =
      judgeStep(*findMethod("rk4"), torques, Eigen::Quaterniond(1, 0, 0, 0), {1, 2, 3}, 0.5);
  std::printf("judgement %d %s\n", static_cast<int>(judgement.grade), judgement.reason.c_str());
  print("largest_sound", judgement.largest_sound);
}

void printRotations() {
  const Eigen::Vector3d theta(0.1, -0.7, 0.4);
  const Eigen::Quaterniond q = expQuaternion(theta);
  print("exp", q);
  print("exp", expQuaternion(5 * theta));
  print("exp", expMatrix(theta));
  print("log", logQuaternion(q));
  print("log", logMatrix(expMatrix(theta)));
  print("hat", hat(theta));
  print("angle", angleBetween(q, Eigen::Quaterniond::Identity()));
  print("orthogonality", orthogonalityError(expMatrix(theta)));
}

/** What the library throws is caught here as what it is. */
void printExceptions() {
  try {
    PrincipalInertia::fromMoments({1, 2, -3});
  } catch (const std::invalid_argument& error) {
    std::printf("invalid_argument: %s\n", error.what());
  }
  try {
    Motion motion(setupOf("midpoint", 2.7, PrincipalInertia::fromMoments({1, 20, 400})));
    motion.at(1000);
  } catch (const NoConvergence& error) {
    std::printf("NoConvergence: %s\n", error.what());
  }
}

}  // namespace

int main() {
  printLayouts();
  printMotions();
  printClosedForms();
  printAssemblies();
  printSteppers();
  printRotations();
  printExceptions();
}
