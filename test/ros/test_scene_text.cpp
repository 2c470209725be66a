// What a node says of its scene, and what --check says of it.
#include "poinsot/ros/scene_text.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "poinsot/scene/reader.h"

namespace {

using poinsot::node::checkedText;
using poinsot::node::playedText;

poinsot::scene::Scene sceneOf(const std::string& bodies) {
  return poinsot::scene::readTree(YAML::Load("bodies: [" + bodies + "]"), "the test");
}

std::string body(const std::string& name, const std::string& keys, int place = 0) {
  return "{name: " + name + ", inertia: [1, 2, 3], " + keys + ", effects: [{type: translation, position: [0, 0, " +
         std::to_string(3 * place) + "]}]}";
}

TEST(PlayedText, namesSceneRateNamespaceAndEachBody) {
  const auto scene = sceneOf(body("a", "angular_velocity: [0, 1, 3]") + ", " +
                             body("b", "angular_velocity: [0, 1, 3], method: rk4, step: 0.01", 1));
  EXPECT_EQ(playedText(scene, {"scene two (/x/two.yaml)", 20, "/robot1", ""}),
            "playing scene two (/x/two.yaml) at 20 Hz in namespace /robot1: a by closed_form; b by rk4 with a step of "
            "0.01 s");
  EXPECT_EQ(playedText(sceneOf(body("a", "angular_velocity: [0, 1, 3]")), {"scene one", 60, "/", "r/"}),
            "playing scene one at 60 Hz in namespace /, frames with the prefix r/: a by closed_form");
}

TEST(CheckedText, givesMethodAndRegimeOfEachBody) {
  const std::string free = body("largest", "angular_velocity: [0, 1, 3]") + ", " +
                           body("smallest", "angular_velocity: [3, 1, 0], method: rk4, step: 0.01", 1) + ", " +
                           body("steady", "angular_velocity: [0, 1, 0]", 2) + ", " +
                           body("rests", "angular_velocity: [0, 0, 0]", 3);
  EXPECT_EQ(checkedText(sceneOf(free)),
            "largest: closed_form, about the axis of largest moment\n"
            "smallest: rk4 with a step of 0.01 s, about the axis of smallest moment\n"
            "steady: closed_form, steady about the axis of intermediate moment\n"
            "rests: closed_form, at rest\n"
            "no fault\n");
  EXPECT_EQ(checkedText(sceneOf("{name: top, inertia: [1, 2, 3], angular_velocity: [0, 1, 0], method: rk4, step: 0.01, "
                                "effects: [{type: viscous_damping, coefficient: 1}]}")),
            "top: rk4 with a step of 0.01 s, under torque\nno fault\n");
}

TEST(CheckedText, countsWarnings) {
  const auto ends = [](const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
  };
  poinsot::scene::Scene scene = sceneOf(body("a", "angular_velocity: [0, 1, 3]"));
  scene.warnings = {"one"};
  EXPECT_TRUE(ends(checkedText(scene), "\nno fault, one warning\n")) << checkedText(scene);
  scene.warnings.push_back("two");
  EXPECT_TRUE(ends(checkedText(scene), "\nno fault, 2 warnings\n")) << checkedText(scene);
}

TEST(CheckedText, manyBodiesAreCounted) {
  std::string many;
  for (int i = 0; i < 25; ++i)
    many += (i ? ", " : "") + body("b" + std::to_string(i), "angular_velocity: [0, 1, 3]", i);
  const auto scene = sceneOf(many);
  EXPECT_NE(checkedText(scene).find("b19: closed_form, about the axis of largest moment\nand 5 more\nno fault\n"),
            std::string::npos)
      << checkedText(scene);
  EXPECT_NE(playedText(scene, {"scene many", 60, "/", ""}).find("; b19 by closed_form; and 5 more"), std::string::npos);
}

}  // namespace
