// The table of costs by which methods are chosen.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "poinsot/core/closed_form.h"
#include "poinsot/core/method.h"
#include "poinsot/cost/method_costs.h"
#include "poinsot/cost/resolve_accuracy.h"
#include "poinsot/scene/reader.h"

using namespace poinsot;

namespace {

TEST(NominalCosts, everyMethodHasOne) {
  const cost::MethodCosts& costs = cost::nominalCosts();
  EXPECT_EQ(costs.all().size(), freeMethods().size() + torquedMethods().size() + 1);
  EXPECT_EQ(costs.of(kClosedForm).per_step, 0);
  for (const Method& method : freeMethods()) {
    EXPECT_GT(costs.of(method.name).per_step, 0) << method.name;
    EXPECT_GT(costs.of(method.name).per_state, 0) << method.name;
  }
  for (const Method& method : torquedMethods()) {
    EXPECT_GT(costs.of(cost::costName(method.name, true)).per_step, 0) << method.name;
    EXPECT_GT(costs.of(cost::costName(method.name, true)).per_state, 0) << method.name;
  }
}

TEST(NominalCosts, chooseTheSameEveryTime) {
  std::vector<std::string> sentences[2];
  for (auto& out : sentences) {
    scene::Scene scene = scene::readTree(
        YAML::Load("bodies: [{name: top, inertia: [1, 2, 3], angular_velocity: [0.3, 1, 0.2], method: stepper, "
                   "accuracy: 1e-7, horizon: 20}]"),
        "scene");
    out = cost::resolveAccuracies(scene, 60);
    EXPECT_TRUE(scene.bodies[0].step);
  }
  EXPECT_EQ(sentences[0], sentences[1]);
}

}  // namespace
