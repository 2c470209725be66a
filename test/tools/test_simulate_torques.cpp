// Bodies with torques through the program, as its users meet it.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "comparisons.h"
#include "run_program.h"
#include "torque_rows.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

struct State {
  double t;
  Eigen::Quaterniond attitude;
  Eigen::Vector3d omega;
};

/** The last row of a CSV. */
State lastOf(const std::string& csv) {
  const std::size_t end = csv.find_last_not_of('\n'), begin = csv.rfind('\n', end) + 1;
  std::istringstream cells(csv.substr(begin, end + 1 - begin));
  std::string cell;
  std::getline(cells, cell, ',');
  std::vector<double> v;
  while (std::getline(cells, cell, ',')) v.push_back(std::strtod(cell.c_str(), nullptr));
  if (v.size() != 11) throw std::runtime_error("no row: " + csv.substr(begin));
  return {v[0], {v[1], v[2], v[3], v[4]}, {v[5], v[6], v[7]}};
}

class SimulateTorques : public testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/poinsot_torques.XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    directory_ = name;
  }
  void TearDown() override { fs::remove_all(directory_); }

  Outcome simulate(const std::string& scene, double duration, const std::string& before = "") const {
    std::ofstream(directory_ / "scene.yaml") << scene;
    char time[32];
    std::snprintf(time, sizeof time, "%.17g", duration);
    return runProgram(before + " " + shellWord(SIMULATE) + " " + (directory_ / "scene.yaml").string() + " --duration " +
                          time + " --rate 10 --csv -",
                      "");
  }

  void meets(const TorqueRow& row) const {
    for (const char* const accuracy : {"1e-9", "1e-12"}) {
      const Outcome outcome = simulate(row.scene(std::string("accuracy: ") + accuracy), row.t);
      ASSERT_EQ(outcome.exit_code, 0) << row.id << "\n" << outcome.err;
      const State state = lastOf(outcome.out);
      EXPECT_EQ(state.t, row.t);
      const double allowed = std::strtod(accuracy, nullptr);
      EXPECT_LE(row.attitudeError(state.attitude), allowed + 16 * row.cond_rad) << row.id << " " << row.note;
      EXPECT_LE(row.omegaError(state.omega), allowed + 16 * row.cond_omega) << row.id << " " << row.note;
    }
  }

  fs::path directory_;
};

TEST_F(SimulateTorques, meetsRows) {
  int met = 0;
  for (const TorqueRow& row : readTorqueColumns(TEST_DATA_DIR "/torque.csv")) {
    const int number = std::atoi(row.id.c_str() + 1);
    if (number % 5 != 0) continue;  // the last, and longest, of each kind
    meets(row);
    ++met;
  }
  EXPECT_EQ(met, 7);
  for (const TorqueRow& row : readTorqueScenes(TEST_DATA_DIR "/torque_rows.csv")) {
    if (row.id != "R004" && row.id != "R013" && row.id != "R024" && row.id != "R033" && row.id != "R051") continue;
    meets(row);
    ++met;
  }
  EXPECT_EQ(met, 12);
}

// Older processors get the same to rounding, by other instructions: the last digits show that they were others.
TEST_F(SimulateTorques, olderProcessorsGetTheSameToRounding) {
  int different = 0;
  for (const TorqueRow& row : readTorqueScenes(TEST_DATA_DIR "/torque_rows.csv")) {
    if (row.id != "R004" && row.id != "R013" && row.id != "R024" && row.id != "R033" && row.id != "R051") continue;
    for (const char* const method : {"taylor8, step: 0.02", "taylor16, step: 0.1", "taylor24, step: 0.2"}) {
      const std::string scene = row.scene(std::string("method: ") + method);
      const Outcome plain = simulate(scene, row.t, "POINSOT_SIMD=baseline"), best = simulate(scene, row.t);
      ASSERT_EQ(plain.exit_code, 0) << plain.err;
      ASSERT_EQ(best.exit_code, 0) << best.err;
      const State a = lastOf(plain.out), b = lastOf(best.out);
      EXPECT_LE(angle(a.attitude, b.attitude), 2e-14 + 16 * row.cond_rad) << row.id << " " << method;
      EXPECT_LE(relativeDifference(a.omega, b.omega), 2e-14 + 16 * row.cond_omega) << row.id << " " << method;
      different += plain.out == best.out ? 0 : 1;
    }
  }
  std::ifstream in("/proc/cpuinfo");
  std::stringstream processor;
  processor << in.rdbuf();
  if (processor.str().find(" avx2 ") != std::string::npos) {
    EXPECT_GT(different, 0);
  }
}

TEST_F(SimulateTorques, defaultsToWhatIsAsGoodAsCanBe) {
  for (const TorqueRow& row : readTorqueColumns(TEST_DATA_DIR "/torque.csv")) {
    if (row.id != "T010") continue;
    std::string scene = row.scene("");
    scene.replace(scene.find(", , "), 4, ", ");
    const Outcome outcome = simulate(scene, row.t);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_LE(row.attitudeError(lastOf(outcome.out).attitude), 1e-9);
  }
}

TEST_F(SimulateTorques, refusesAClosedFormWithATorque) {
  const Outcome outcome = simulate(
      "bodies: [{name: top, inertia: [1, 2, 3], angular_velocity: [0, 1, 0], method: closed_form, "
      "effects: [{type: viscous_damping, coefficient: 1}]}]",
      1);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(
      outcome.err.find("got \"closed_form\": it is the motion of a free body, and viscous_damping changes that motion"),
      std::string::npos)
      << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

}  // namespace
}  // namespace poinsot
