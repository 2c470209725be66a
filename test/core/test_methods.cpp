#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "draws.h"
#include "poinsot/core/method.h"
#include "poinsot/core/no_convergence.h"
#include "poinsot/core/rotation.h"

namespace poinsot {
namespace {

TEST(Methods, namesAreUniqueAndFound) {
  std::set<std::string> names;
  for (const Method& method : methods()) {
    EXPECT_TRUE(names.insert(method.name).second) << method.name << " is there twice";
    EXPECT_EQ(findMethod(method.name), &method);
    EXPECT_EQ(findMethod(method.name, freeMethods()) != nullptr, method.make_free != nullptr) << method.name;
    EXPECT_EQ(findMethod(method.name, torquedMethods()) != nullptr, method.make_torqued != nullptr) << method.name;
    EXPECT_NE(methodNames(methods()).find(method.name), std::string::npos);
    EXPECT_GE(method.order, 1);
  }
  EXPECT_EQ(methodNames(torquedMethods()), "taylor8, taylor12, taylor16, taylor20, taylor24, aba84, buss2, rk4");
  for (const char* name : {"lie_euler", "buss2", "rk4"}) EXPECT_TRUE(findMethod(name)) << name;
}

TEST(Methods, unknownNamesAreNotFound) {
  for (const char* name : {"", "rk", "rk45", "RK4", " rk4", "lie_euler,"}) EXPECT_EQ(findMethod(name), nullptr) << name;
}

class EveryMethod : public ::testing::TestWithParam<std::string> {
 protected:
  const Method& method() const { return *findMethod(GetParam()); }
};

TEST_P(EveryMethod, batchesAddUpBitForBit) {
  Draws draws;
  const Eigen::Vector3d moments = draws.moments();
  const auto stepper = method().make(moments);
  const RotationState start = RotationState::fromOmega(moments, draws.attitude(), draws.vector());
  RotationState once = start, parts = start;
  stepper->advance(once, 0, 0.01, 1000);
  for (const int count : {0, 1, 999 - 500, 0, 500}) stepper->advance(parts, 0, 0.01, count);
  EXPECT_EQ(once.attitude.coeffs(), parts.attitude.coeffs());
  EXPECT_EQ(once.momentum_principal, parts.momentum_principal);
}

TEST_P(EveryMethod, leavesABodyAtRestAlone) {
  RotationState state;
  state.attitude = Draws().attitude();
  const Eigen::Vector4d before = state.attitude.coeffs();
  method().make({1, 2, 3})->advance(state, 0, 0.1, 1000);
  EXPECT_LE((state.attitude.coeffs() - before).norm(), 1e-15);
  EXPECT_EQ(state.momentum_principal, Eigen::Vector3d(0, 0, 0));
}

TEST_P(EveryMethod, keepsTheQuaternionUnit) {
  Draws draws;
  const Eigen::Vector3d moments = draws.moments();
  RotationState state = RotationState::fromOmega(moments, draws.attitude(), draws.vector());
  method().make(moments)->advance(state, 0, 0.05, 100000);
  EXPECT_NEAR(state.attitude.norm(), 1, 1e-15);
}

TEST_P(EveryMethod, spinsASphereSteadily) {
  // Equal moments: Ω is constant and the attitude is exp(Ωt).
  const Eigen::Vector3d omega(0.3, -0.8, 1.5);
  RotationState state = RotationState::fromOmega({2, 2, 2}, Eigen::Quaterniond::Identity(), omega);
  method().make({2, 2, 2})->advance(state, 0, 0.001, 5000);
  EXPECT_LE((state.omegaPrincipal({2, 2, 2}) - omega).norm(), 1e-12);
  // Without a sine, the angle of a step is twice an arctangent: off by θ³/6, |θ| = 0.0017, in each of 5000 steps.
  const double off = GetParam() == "dmv2" ? 5e-6 : 1e-11;
  EXPECT_LE(angleBetween(state.attitude, expQuaternion(5 * omega)), off);
}

TEST_P(EveryMethod, goesBackTheWayItCameOnlyIfItIsSymmetric) {
  const bool symmetric = GetParam() == "midpoint" || GetParam().rfind("splitting", 0) == 0 || GetParam()[0] == 'd';
  Draws draws;
  double least = 1, most = 0;
  for (int body = 0; body < 20; ++body) {
    const Eigen::Vector3d moments = draws.moments();
    const auto stepper = method().make(moments);
    const RotationState start = RotationState::fromOmega(moments, draws.attitude(), draws.direction());
    RotationState state = start;
    stepper->advance(state, 0, 0.8, 1);
    EXPECT_GT(angleBetween(state.attitude, start.attitude), 0.5);
    stepper->advance(state, 0, -0.8, 1);
    const double off = angleBetween(state.attitude, start.attitude) +
                       (state.momentum_principal - start.momentum_principal).norm() / start.momentum_principal.norm();
    least = std::min(least, off);
    most = std::max(most, off);
  }
  std::printf("%-10s there and back: off by %.1e to %.1e\n", GetParam().c_str(), least, most);
  if (symmetric) {
    EXPECT_LE(most, 4e-15);
  } else {
    EXPECT_GE(most, 1e-6);
  }
}

/** Every bit of the state. */
void expectTheSame(const RotationState& a, const RotationState& b) {
  EXPECT_EQ(a.attitude.coeffs(), b.attitude.coeffs());
  EXPECT_EQ(a.momentum_principal, b.momentum_principal);
  EXPECT_EQ(a.attitude_rest, b.attitude_rest);
  EXPECT_EQ(a.momentum_rest, b.momentum_rest);
  EXPECT_EQ(a.kept_momentum, b.kept_momentum);
  EXPECT_EQ(a.kept_inverse_square, b.kept_inverse_square);
  EXPECT_EQ(a.steps_since_restored, b.steps_since_restored);
  EXPECT_EQ(a.kept_inverse_inertia, b.kept_inverse_inertia);
}

TEST(NoConvergence, leavesTheStateAsItWas) {
  for (const char* name : {"midpoint", "dmv2", "dmv4", "dmv6", "dmv8", "dmv10"}) {
    Draws draws;
    int thrown = 0;
    for (int body = 0; body < 20; ++body) {
      // Momenta and moments of extreme size are scaled inside, and have to come back.
      for (const double size : {1.0, 1e-200, 1e120}) {
        for (const double weight : {1.0, 1e-120}) {
          const Eigen::Vector3d moments = weight * draws.moments();
          const auto stepper = findMethod(name)->make(moments);
          RotationState state = RotationState::fromOmega(moments, draws.attitude(), size * draws.direction());
          stepper->advance(state, 0, 0.01 / size, 3);
          const RotationState before = state;
          for (const double turned : {5.0, 20.0, 300.0}) {
            try {
              stepper->advance(state, 0, turned / size, 100);
              state = before;
            } catch (const NoConvergence& error) {
              ++thrown;
              EXPECT_EQ(std::string(error.what()).rfind(name + std::string(" "), 0), 0u) << error.what();
              expectTheSame(state, before);
              if (HasFailure()) FAIL() << name << " " << size << " " << weight;
            }
          }
        }
      }
    }
    EXPECT_GE(thrown, 20) << name;
  }
}

std::vector<std::string> names() {
  std::vector<std::string> out;
  for (const Method& method : freeMethods()) out.push_back(method.name);
  return out;
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod, ::testing::ValuesIn(names()),
                         [](const auto& instance) { return instance.param; });

}  // namespace
TEST(Methods, sayWhatTheirStepsTook) {
  const Eigen::Vector3d moments(1, 2, 3);
  const std::map<std::string, Work> one_step = {
      {"lie_euler", {1, 1}}, {"buss2", {2, 1}},      {"buss3", {3, 1}},       {"buss4", {4, 1}},       {"rk4", {4, 0}},
      {"rkmk4", {4, 4}},     {"splitting2", {0, 4}}, {"splitting4", {0, 14}}, {"splitting6", {0, 22}}, {"cf4", {4, 5}}};
  for (const Method& method : freeMethods()) {
    SCOPED_TRACE(method.name);
    const auto stepper = method.make(moments);
    RotationState state = RotationState::fromOmega(moments, Eigen::Quaterniond::Identity(), {0.6, 0.5, 0.7});
    const Work work = stepper->advance(state, 0, 0.1, 50);
    if (const auto expected = one_step.find(method.name); expected != one_step.end()) {
      EXPECT_EQ(work.evaluations, 50 * expected->second.evaluations);
      EXPECT_EQ(work.exponentials, 50 * expected->second.exponentials);
      continue;
    }
    // Implicit: between one and ten iterations a step, and more of them the longer the step.
    EXPECT_GE(work.evaluations, 50);
    EXPECT_LE(work.evaluations, 50 * 12);
    EXPECT_GE(stepper->advance(state, 0, 0.8, 50).evaluations, work.evaluations);
    EXPECT_LE(stepper->advance(state, 0, 1e-6, 50).evaluations, work.evaluations);
  }
}

}  // namespace poinsot
