// The program as its users meet it: a process with arguments, stdout, stderr and an exit code. No test asks how long
// anything took.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include "run_program.h"

namespace poinsot {
namespace {

const std::vector<std::string> kParts = {"free_motion",          "translation",      "constant_torque",
                                         "gravity_torque",       "gravity_gradient", "viscous_damping",
                                         "internal_dissipation", "torque_schedule",  "total"};
const std::string kFree = "name: a, inertia: [1, 2, 3], angular_velocity: [0.1, 1, 0.2]";

/** A scene file that is gone with its object. */
class SceneFile {
 public:
  explicit SceneFile(const std::string& content) { std::ofstream(path) << content; }
  ~SceneFile() { std::remove(path.c_str()); }
  const std::string path = ::testing::TempDir() + "scene_cost_test.yaml";
  const std::string word = shellWord(path);  ///< on a command line
};

std::string oneBody(const std::string& more) {
  return "bodies: [{" + kFree + (more.empty() ? "" : ", " + more) + "}]\n";
}

Outcome sceneCost(const std::string& arguments) {
  return runProgram(shellWord(SCENE_COST) + " " + arguments, "");
}

using Row = std::map<std::string, std::string>;

/** The rows of `--csv -`. */
std::vector<Row> rowsOf(const std::string& csv) {
  const auto cells = [](const std::string& line) {
    std::vector<std::string> out;
    std::istringstream in(line + ",");
    for (std::string cell; std::getline(in, cell, ',');) out.push_back(cell);
    return out;
  };
  std::istringstream in(csv);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = cells(line);
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    const std::vector<std::string> values = cells(line);
    EXPECT_EQ(values.size(), names.size()) << line;
    rows.emplace_back();
    for (std::size_t i = 0; i < std::min(values.size(), names.size()); ++i) rows.back()[names[i]] = values[i];
  }
  return rows;
}

double number(const Row& row, const char* column) {
  return std::stod(row.at(column));
}

std::vector<Row> rowsOfScene(const std::string& scene, const std::string& options = "") {
  const SceneFile file(scene);
  const Outcome outcome = sceneCost("--csv - " + options + " " + file.word);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return rowsOf(outcome.out);
}

/** That a body's rows are all there and add up. @return the last, `total`. */
Row expectCostBreakdown(const std::vector<Row>& rows, double steps, double states) {
  Row total;
  if (rows.size() != kParts.size()) {
    ADD_FAILURE() << rows.size() << " rows";
    return total;
  }
  std::map<std::string, double> sums;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    SCOPED_TRACE(kParts[i]);
    EXPECT_EQ(rows[i].at("part"), kParts[i]);
    const double together = steps * number(rows[i], "ns_per_step") + states * number(rows[i], "ns_per_state");
    const double scale = 1e-6 * number(rows.back(), "ns_per_simulated_s");
    EXPECT_NEAR(number(rows[i], "ns_per_simulated_s"), together, scale);
    for (const char* column : {"ns_per_step", "ns_per_state", "ns_per_simulated_s", "share"}) {
      if (rows[i].at("in_force") == "0") {
        EXPECT_EQ(rows[i].at(column), "0") << column;
      }
      if (kParts[i] != "total") sums[column] += number(rows[i], column);
    }
  }
  total = rows.back();
  for (const auto& [column, sum] : sums) {
    EXPECT_NEAR(sum, number(total, column.c_str()), 1e-6 * std::abs(number(total, column.c_str())) + 1e-9) << column;
  }
  EXPECT_NEAR(number(total, "share"), 1, 1e-6);
  EXPECT_GT(number(total, "ns_of_a_run_per_simulated_s"), 0);
  return total;
}

std::string inForce(const std::vector<Row>& rows) {
  std::string out;
  for (const Row& row : rows) {
    if (row.at("in_force") == "1") out += (out.empty() ? "" : " ") + row.at("part");
  }
  return out;
}

TEST(SceneCost, aFreeBodyPaysForNoEffect) {
  const std::vector<Row> closed = rowsOfScene(oneBody(""));
  EXPECT_EQ(inForce(closed), "free_motion total");
  const Row total = expectCostBreakdown(closed, 0, 60);
  EXPECT_EQ(total.at("method"), "closed_form");
  EXPECT_EQ(total.at("step"), "");
  EXPECT_EQ(total.at("ns_per_step"), "0");
  EXPECT_EQ(total.at("torque_evaluations_per_s"), "0");

  const std::vector<Row> stepped = rowsOfScene(oneBody("method: dmv8, step: 0.01"), "--rate 10");
  EXPECT_EQ(inForce(stepped), "free_motion total");
  const Row stepped_total = expectCostBreakdown(stepped, 100, 10);
  EXPECT_GT(number(stepped_total, "ns_per_step"), 0);
  EXPECT_EQ(stepped_total.at("torque_evaluations_per_s"), "0");
}

TEST(SceneCost, whatIsNotThereIsAPlainZeroInTheTable) {
  const SceneFile file(oneBody(""));
  const Outcome outcome = sceneCost(file.word);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("closed_form"), std::string::npos) << outcome.out;
  int zeros = 0;
  std::istringstream in(outcome.out);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string name, step, state, second, share;
    words >> name >> step >> state >> second >> share;
    const bool is_effect = std::find(kParts.begin() + 1, kParts.end() - 1, name) != kParts.end() - 1;
    if (!is_effect) continue;
    ++zeros;
    EXPECT_EQ(step + state + second + share, "0000") << line;
  }
  EXPECT_EQ(zeros, 7);
}

TEST(SceneCost, translationIsPaidByTheStateAndNotByTheStep) {
  const std::vector<Row> rows =
      rowsOfScene(oneBody("method: rk4, step: 0.01, effects: [{type: translation, velocity: [0, 0, 1]}]"));
  EXPECT_EQ(inForce(rows), "free_motion translation total");
  expectCostBreakdown(rows, 100, 60);
  EXPECT_EQ(rows[1].at("ns_per_step"), "0");
}

TEST(SceneCost, severalEffectsAddUp) {
  const std::vector<Row> rows = rowsOfScene(
      oneBody("method: taylor8, step: 0.0625, effects: ["
              "{type: translation, velocity: [0, 0, 1]}, "
              "{type: constant_torque, frame: world, torque: [0.1, 0, 0]}, "
              "{type: constant_torque, frame: body, torque: [0.1, 0, 0]}, "
              "{type: gravity_gradient, orbit_rate: 0.1, orbit_normal: [0, 0, 1], radial_at_start: [1, 0, 0]}, "
              "{type: viscous_damping, coefficient: 0.1}, "
              "{type: internal_dissipation, slug_inertia: 0.1, damping: 0.1}, "
              "{type: torque_schedule, segments: [{from: 1, to: 2, frame: body, torque: [0, 1, 0]}]}]"),
      "--rate 64 --duration 5");
  EXPECT_EQ(inForce(rows),
            "free_motion translation constant_torque gravity_gradient viscous_damping internal_dissipation "
            "torque_schedule total");
  expectCostBreakdown(rows, 16, 64);
}

TEST(SceneCost, torqueEvaluationsAreThoseOfTheMethod) {
  // Two steps to a state and none cut: as many evaluations as the method is known to need, and one for each state.
  const std::pair<const char*, int> methods[] = {{"rk4", 4}, {"buss2", 2}, {"aba84", 5}, {"taylor8", 8}};
  for (const auto& [method, evaluations] : methods) {
    SCOPED_TRACE(method);
    const std::vector<Row> rows = rowsOfScene(
        oneBody(std::string("method: ") + method +
                ", step: 0.0078125, effects: [{type: gravity_torque, mass: 1, centre_of_mass: [0, 0, 0.1]}]"),
        "--rate 64 --duration 2");
    const Row total = expectCostBreakdown(rows, 128, 64);
    EXPECT_EQ(number(total, "torque_evaluations_per_s"), 128 * evaluations + 64);
  }
}

TEST(SceneCost, saysWhyAMethodWasChosen) {
  const SceneFile file(
      "bodies:\n"
      "  - {name: a, inertia: [1, 2, 3], angular_velocity: [0.1, 1, 0.2]}\n"
      "  - {name: b, inertia: [1, 2, 3], angular_velocity: [0.1, 1, 0.2], method: stepper, accuracy: 1e-3, horizon: "
      "5,\n"
      "     effects: [{type: translation, position: [9, 0, 0]}]}\n"
      "  - {name: c, inertia: [1, 2, 3], angular_velocity: [0.1, 1, 0.2], method: lie_euler, step: 0.001,\n"
      "     effects: [{type: translation, position: [18, 0, 0]}]}\n"
      "  - {name: d, inertia: [1, 2, 3], angular_velocity: [0.1, 1, 0.2],\n"
      "     effects: [{type: viscous_damping, coefficient: 0.1}, {type: translation, position: [27, 0, 0]}]}\n");
  const Outcome outcome = sceneCost("--duration 5 " + file.word);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::size_t at = 0;
  for (const char* words :
       {"\na\n", "no effect", "closed_form", "nothing turns the body", "\nb\n", "translation: position",
        "for an accuracy of 0.001 rad over 5 s", "\nc\n", "lie_euler, step 0.001 s", "the scene names it", "\nd\n",
        "viscous_damping: coefficient", "the scene leaves the choice", "over 5 s", "torque evaluations"}) {
    at = outcome.out.find(words, at);
    ASSERT_NE(at, std::string::npos) << words << " is not there, or too early, in\n" << outcome.out;
  }
}

TEST(SceneCost, writesTheFileWholeOrNotAtAll) {
  const SceneFile file(oneBody(""));
  const std::string csv = ::testing::TempDir() + "scene_cost_test.csv";
  Outcome outcome = sceneCost("--csv " + shellWord(csv) + " " + file.word);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("free_motion"), std::string::npos) << "the table is printed as well";
  std::ostringstream text;
  text << std::ifstream(csv).rdbuf();
  EXPECT_EQ(rowsOf(text.str()).size(), kParts.size());
  std::remove(csv.c_str());

  for (const std::string& words :
       {"--csv /nowhere/a.csv " + file.word, "--csv /dev/full " + file.word, file.word + " > /dev/full"}) {
    outcome = sceneCost(words);
    EXPECT_EQ(outcome.exit_code, 1) << words;
    EXPECT_NE(outcome.err.find("cannot write"), std::string::npos) << outcome.err;
  }
}

TEST(SceneCost, badUse) {
  const SceneFile file(oneBody("method: rk4, step: 0.001"));
  const auto expectRefusal = [](const std::string& arguments, const std::string& words) {
    const Outcome outcome = sceneCost(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  };
  expectRefusal("", "scene is required");
  expectRefusal("/nowhere/scene.yaml", "/nowhere/scene.yaml");
  expectRefusal(file.word + " --rate 0", "scene_cost: --rate: expected a positive finite number (Hz), got \"0\"\n");
  expectRefusal(file.word + " --rate inf", "--rate: expected a positive finite number (Hz), got \"inf\"\n");
  expectRefusal(file.word + " --duration -3", "--duration: expected a positive finite number (s), got \"-3\"\n");
  expectRefusal(file.word + " --duration soon", "--duration: expected a positive finite number (s), got \"soon\"\n");
  expectRefusal(file.word + " --duration 1e7",
                "--duration: expected at most 1e+09 steps of body a, got 1e+10 (1e+07 s)\n");
  expectRefusal(file.word + " --duration 1e6 --rate 1e6",
                "--duration: expected at most 1e+09 states, got 1e+12 (1e+06 s at 1e+06 Hz)\n");
  expectRefusal(file.word + " --colour", "--colour");
  expectRefusal(file.word + " --csv ''", "--csv: expected a value, got \"\"\n");
  expectRefusal(file.word + " --csv " + file.word, "--csv: expected a file other than the scene, got ");
  const SceneFile torqued(oneBody("method: closed_form, effects: [{type: viscous_damping, coefficient: 1}]"));
  expectRefusal(torqued.word, "got \"closed_form\": it is the motion of a free body");
}

TEST(SceneCost, aMotionThatIsLostIsSaid) {
  const SceneFile file(oneBody("effects: [{type: translation, acceleration: [1e308, 0, 0]}]"));
  const Outcome outcome = sceneCost(file.word);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("body a under closed_form"), std::string::npos) << outcome.err;
}

TEST(SceneCost, helps) {
  const Outcome outcome = sceneCost("--help");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("--duration"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace poinsot
