// The program as its users meet it: a process with arguments, stdout, stderr and an exit code.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

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

TEST(CompareScene, aLessonIsARowOfTheTwoAlgorithmsAndTheClosedForm) {
  for (const std::string& arguments : std::vector<std::string>{"", "--step 0.01 "}) {
    const Outcome outcome = compareScene("--mode lesson " + arguments + kFlip);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const YAML::Node bodies = YAML::Load(outcome.out)["bodies"];
    ASSERT_EQ(bodies.size(), 3u);
    double last = -1e9;
    for (std::size_t i = 0; i < 3; ++i) {
      const YAML::Node body = bodies[i];
      const std::string name = body["name"].as<std::string>();
      EXPECT_EQ(name, (std::vector<std::string>{"lie_euler", "buss2", "closed_form"}[i]));
      EXPECT_EQ(body["method"].as<std::string>(), name);
      EXPECT_EQ(!body["step"], name == "closed_form");
      if (body["step"]) {
        EXPECT_EQ(body["step"].as<double>(), arguments.empty() ? 1.0 / 60 : 0.01) << arguments;
      }
      const auto place = body["effects"][0]["position"].as<std::vector<double>>();
      EXPECT_GT(place[1], last + 2) << "to the right of the one before";
      EXPECT_EQ(place[2], 0);
      last = place[1];
    }
  }
}

/** Without its own method, a body under torques is one under the steppers of free bodies. */
TEST(CompareScene, aBodyWithItsOwnMethodIsTakenWithoutIt) {
  const std::string start = "bodies:\n  - {name: a, inertia: [1, 2, 3], angular_velocity: [0.1, 1, 0.1], ";
  const std::string torque = "effects: [{type: viscous_damping, coefficient: 0.1}]";
  for (const std::string& own : {std::string("method: rk4, step: 0.003"), std::string("method: closed_form"),
                                 std::string("method: stepper, accuracy: 1e-4, horizon: 10"),
                                 "method: taylor16, step: 0.5, " + torque, "method: buss2, step: 0.01, " + torque}) {
    for (const std::string& mode : std::vector<std::string>{"equal_cost", "equal_step", "lesson"}) {
      const SceneFile file(start + own + "}\n");
      const Outcome outcome = compareScene("--mode " + mode + " " + file.word);
      ASSERT_EQ(outcome.exit_code, 0) << own << ", " << mode << ": " << outcome.err;
      for (const auto& body : YAML::Load(outcome.out)["bodies"]) {
        EXPECT_EQ(body["method"].as<std::string>(), body["name"].as<std::string>()) << own;
        EXPECT_EQ(body["name"].as<std::string>() == "closed_form", !body["step"]) << own;
        EXPECT_NE(body["step"].as<double>(0), 0.003) << own;
        EXPECT_FALSE(body["accuracy"] || body["horizon"]) << own;
        ASSERT_EQ(body["effects"].size(), 1u) << own;
        EXPECT_EQ(body["effects"][0]["type"].as<std::string>(), "translation") << own;
      }
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
                "compare_scene: --mode: expected one of equal_cost, equal_step, lesson, got \"equal_luck\"\n");
  expectRefusal("--step -1 " + kFlip, "--step: expected a positive finite number (s), got \"-1\"\n");
  expectRefusal("--body nobody " + kFlip, "--body: expected one of wingnut");
  expectRefusal("/nowhere/scene.yaml", "/nowhere/scene.yaml");
  expectRefusal("--mode equal_step --step 50 " + kFlip, "lie_euler with a step of 50 s");
  expectRefusal("--mode lesson --step 50 " + kFlip, "lie_euler with a step of 50 s");
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
