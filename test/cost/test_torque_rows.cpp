// What a scene that names an accuracy makes of every row with torques: read, settled, moved, and held to the row.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "poinsot/cost/method_costs.h"
#include "poinsot/cost/resolve_accuracy.h"
#include "poinsot/scene/motion_setup.h"
#include "poinsot/scene/reader.h"
#include "torque_rows.h"

namespace poinsot {
namespace {

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

scene::Scene read(const TorqueRow& row, const std::string& method) {
  return scene::readTree(YAML::Load(row.scene(method)), row.id);
}

scene::Body settled(const TorqueRow& row, const std::string& accuracy) {
  scene::Scene scene = read(row, "accuracy: " + accuracy + ", horizon: " + shown(row.t));
  cost::resolveAccuracies(scene, scene::kDefaultRate);
  return scene.bodies.at(0);
}

struct Worst {
  double ratio = -1;
  std::string id;
  void meet(double other, const std::string& at) {
    if (!(other <= ratio)) ratio = other, id = at;
  }
};

/**
 * Every row, none left out. The accuracy is that of the method; beside it stands what the last bit of an input does,
 * times 16 as everywhere (public.csv), which is below a tenth of 1e-12 on all rows of torque.csv. An
 * accuracy is promised for t ≥ 0 only: rows before that are moved by a method and step that suffice for all.
 */
void judge(const std::vector<TorqueRow>& rows, const std::string& accuracy, bool allow_conditioning) {
  const double allowed = std::strtod(accuracy.c_str(), nullptr);
  Worst attitude, omega;
  std::map<std::string, int> methods;
  for (const TorqueRow& row : rows) {
    SCOPED_TRACE(row.id + " " + row.note);
    scene::Body body;
    ASSERT_NO_THROW(body = row.t < 0 ? read(row, "method: taylor16, step: 0.02").bodies.at(0) : settled(row, accuracy));
    ++methods[body.method];
    const MotionState state = Motion(scene::motionSetup(body)).at(row.t);
    const double angle = row.attitudeError(state.attitude), speed = row.omegaError(state.omega_body);
    EXPECT_LE(angle, allowed + (allow_conditioning ? 16 * row.cond_rad : 0)) << body.method << " " << *body.step;
    EXPECT_LE(speed, allowed + (allow_conditioning ? 16 * row.cond_omega : 0)) << body.method << " " << *body.step;
    attitude.meet(angle / allowed, row.id);
    omega.meet(speed / allowed, row.id);
  }
  std::printf("accuracy %s, %zu rows: worst error of the attitude %.3f of it (%s), of Omega %.3f (%s);",
              accuracy.c_str(), rows.size(), attitude.ratio, attitude.id.c_str(), omega.ratio, omega.id.c_str());
  for (const auto& [name, count] : methods) std::printf(" %d %s", count, name.c_str());
  std::printf("\n");
}

class TorqueRows : public testing::TestWithParam<const char*> {};

TEST_P(TorqueRows, ofTorqueCsvAreMetByWhatIsChosen) {
  const std::vector<TorqueRow> rows = readTorqueColumns(TEST_DATA_DIR "/torque.csv");
  ASSERT_EQ(rows.size(), 35u);
  judge(rows, GetParam(), false);
}

TEST_P(TorqueRows, ofTorqueRowsCsvAreMetByWhatIsChosen) {
  const std::vector<TorqueRow> rows = readTorqueScenes(TEST_DATA_DIR "/torque_rows.csv");
  ASSERT_GE(rows.size(), 50u);
  judge(rows, GetParam(), true);
}

INSTANTIATE_TEST_SUITE_P(To, TorqueRows, testing::Values("1e-4", "1e-9", "1e-12"),
                         [](const auto& instance) { return "accuracy1em" + std::string(instance.param).substr(3); });

// The comparison can fail: a sign, a frame, a digit.
TEST(TorqueRowsJudge, seesASmallChangeOfTheTorque) {
  for (TorqueRow row : readTorqueColumns(TEST_DATA_DIR "/torque.csv")) {
    if (row.id != "T004" && row.id != "T019" && row.id != "T024" && row.id != "T029") continue;
    YAML::Node tree = YAML::Load(row.scene("method: taylor16, step: 0.001"));
    scene::Body body = scene::readTree(tree, row.id).bodies.at(0);
    for (Effect& effect : body.effects) {
      if (auto* weight = std::get_if<GravityTorque>(&effect)) weight->gravity *= 1 + 1e-9;
      if (auto* torque = std::get_if<ConstantTorque>(&effect)) torque->torque *= 1 + 1e-9;
      if (auto* damping = std::get_if<ViscousDamping>(&effect)) damping->coefficients *= 1 + 1e-9;
    }
    const MotionState state = Motion(scene::motionSetup(body)).at(row.t);
    EXPECT_GT(std::max(row.attitudeError(state.attitude), row.omegaError(state.omega_body)), 1e-12) << row.id;
  }
}

}  // namespace
}  // namespace poinsot
