// The program as its users meet it: a process with arguments, stdout, stderr and an exit code.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cstdio>
#include <fstream>

#include "run_program.h"

namespace poinsot {
namespace {

const std::string kFlip = shellWord(SCENES_DIR "/dzhanibekov.yaml");

Outcome compareScene(const std::string& arguments) {
  return runProgram(shellWord(COMPARE_SCENE) + " " + arguments, "");
}

/** A scene file that is gone with its object. */
class SceneFile {
 public:
  explicit SceneFile(const std::string& content) { std::ofstream(path) << content; }
  ~SceneFile() { std::remove(path.c_str()); }
  const std::string path = ::testing::TempDir() + "compare_scene_test.yaml";
  const std::string word = shellWord(path);  ///< on a command line
};

TEST(CompareScene, aBodyOfSeveralIsTakenByItsName) {
  const SceneFile file(
      "rate: 100\nbodies:\n"
      "  - {name: a, inertia: [1, 2, 3], angular_velocity: [1, 0, 0]}\n"
      "  - {name: b, inertia: [4, 5, 6], angular_velocity: [0.1, 1, 0.1], accuracy: 1e-3, horizon: 5}\n");
  const Outcome outcome = compareScene("--mode equal_step --step 0.01 --body b " + file.word);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const YAML::Node scene = YAML::Load(outcome.out);
  EXPECT_EQ(scene["rate"].as<double>(), 100);
  ASSERT_EQ(scene["bodies"].size(), 4u);
  for (const auto& body : scene["bodies"]) {
    EXPECT_EQ(body["inertia"][0].as<double>(), 4);
    EXPECT_FALSE(body["accuracy"]);
    EXPECT_EQ(body["name"].as<std::string>() == "closed_form", !body["step"]);
    if (body["step"]) {
      EXPECT_EQ(body["step"].as<double>(), 0.01);
    }
  }
}

TEST(CompareScene, aSceneThatIsNoRegularFileIsRefused) {
  const Outcome outcome = runProgram("timeout 30 " + shellWord(COMPARE_SCENE) + " /dev/zero", "");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err,
            "compare_scene: /dev/zero: expected a regular file of at most 4194304 bytes, got a character device\n");
}

TEST(CompareScene, outputThatDoesNotArriveIsAnError) {
  const Outcome outcome = compareScene(kFlip + " > /dev/full");
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("cannot write standard output"), std::string::npos) << outcome.err;
}

TEST(CompareScene, badUse) {
  const auto expectRefusal = [](const std::string& arguments, const std::string& words) {
    const Outcome outcome = compareScene(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  };
  expectRefusal("", "scene is required");
  expectRefusal("--mode equal_luck " + kFlip,
                "compare_scene: --mode: expected one of equal_cost, equal_step, got \"equal_luck\"\n");
  expectRefusal("--step -1 " + kFlip, "--step: expected a positive finite number (s), got \"-1\"\n");
  expectRefusal("--body nobody " + kFlip, "--body: expected one of wingnut");
  expectRefusal("/nowhere/scene.yaml", "/nowhere/scene.yaml");
  expectRefusal("--mode equal_step --step 50 " + kFlip, "lie_euler with a step of 50 s");
}

TEST(CompareScene, whatNoStepperCanFollowIsRefused) {
  const SceneFile file("bodies:\n  - {name: wild, inertia: [1, 2, 3], angular_velocity: [1e9, 1e8, 1e7]}\n");
  const Outcome outcome = compareScene(file.word);
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err, "");
}

}  // namespace
}  // namespace poinsot
