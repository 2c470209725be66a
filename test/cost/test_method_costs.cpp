// The file in which measured costs are kept.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "poinsot/core/closed_form.h"
#include "poinsot/core/motion.h"
#include "poinsot/core/stepper.h"
#include "poinsot/core/torque_stepper.h"
#include "poinsot/cost/method_costs.h"
#include "poinsot/cost/nominal_costs.h"
#include "poinsot/cost/settle.h"
#include "poinsot/cost/torque_choice.h"
#include "poinsot/scene/reader.h"

using namespace poinsot;
namespace fs = std::filesystem;

namespace {

/** All methods, for free bodies and under torques, and the closed form. */
const std::size_t kWays = methods().size() + torqueMethods().size() + 1;

class CostFile : public testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/poinsot_costs.XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    directory_ = name;
    file_ = (directory_ / "deep" / "costs.yaml").string();
  }
  void TearDown() override {
    chmod(directory_.c_str(), 0700);
    fs::remove_all(directory_);
  }

  std::string text() const {
    std::ifstream in(file_);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  /** Puts `with` where `what` stands. */
  void edit(const std::string& what, const std::string& with) {
    std::string all = text();
    const std::size_t at = all.find(what);
    ASSERT_NE(at, std::string::npos) << all;
    std::ofstream(file_) << all.replace(at, what.size(), with);
  }
  /** Sets the cost of a step of buss2 in the file, and gives what is then read. */
  double readBack(double cost) {
    YAML::Node tree = YAML::LoadFile(file_);
    tree["methods"]["buss2"]["per_step"] = cost;
    std::ofstream(file_) << tree;
    return cost::costsOfThisMachine(file_).of("buss2").per_step;
  }

  fs::path directory_;
  std::string file_;
};

TEST_F(CostFile, everyMethodIsMeasuredAndKept) {
  const cost::MethodCosts measured = cost::costsOfThisMachine(file_);
  EXPECT_EQ(measured.all().size(), kWays);
  for (const Method& method : methods()) {
    EXPECT_GT(measured.of(method.name).per_step, 1e-9) << method.name;
    EXPECT_LT(measured.of(method.name).per_step, 1e-4) << method.name;
    EXPECT_GE(measured.of(method.name).per_state, 0) << method.name;
  }
  for (const TorqueMethod& method : torqueMethods()) {
    const std::string name = cost::torqueCostName(method.name);
    EXPECT_GT(measured.of(name).per_step, 1e-9) << name;
    EXPECT_LT(measured.of(name).per_step, 1e-4) << name;
    EXPECT_GE(measured.of(name).per_state, 0) << name;
  }
  EXPECT_GT(measured.of(kClosedForm).per_state, 1e-9);
  EXPECT_EQ(measured.of(kClosedForm).per_step, 0);
  EXPECT_EQ(YAML::LoadFile(file_)["methods"].size(), kWays);
  EXPECT_EQ(readBack(0.123), 0.123) << "the file was not read";
}

TEST_F(CostFile, measuredAgainOnRequest) {
  cost::costsOfThisMachine(file_);
  EXPECT_EQ(readBack(0.123), 0.123);
  EXPECT_LT(cost::costsOfThisMachine(file_, true).of("buss2").per_step, 0.1);
  EXPECT_EQ(text().find("0.123"), std::string::npos);
}

TEST_F(CostFile, ofAnotherMachineOrBrokenIsMeasuredAgain) {
  cost::costsOfThisMachine(file_);
  const std::string good = text();
  const std::pair<const char*, const char*> breakages[] = {
      {"processor: ", "processor: not "}, {"version: ", "version: 9"},     {"dmv10", "dmv99"},
      {"methods:", "methods: ["},         {"per_state: ", "per_state: -"}, {"per_step", "per_stop"}};
  for (const auto& [what, with] : breakages) {
    SCOPED_TRACE(with);
    std::ofstream(file_) << good;
    edit(what, with);
    const cost::MethodCosts costs = cost::costsOfThisMachine(file_);
    EXPECT_EQ(costs.all().size(), kWays);
    EXPECT_EQ(costs.all().count("dmv99"), 0u);
    EXPECT_EQ(YAML::LoadFile(file_)["methods"].size(), kWays) << "not mended";
    EXPECT_EQ(text().find(with == std::string("version: 9") ? "version: 9" : "not "), std::string::npos);
  }
}

TEST_F(CostFile, thatIsAPipeIsReplaced) {
  fs::create_directories(fs::path(file_).parent_path());
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  alarm(120);  // a reader that waits for the pipe's other end ends the test
  cost::costsOfThisMachine(file_);
  alarm(0);
  EXPECT_TRUE(fs::is_regular_file(file_));
}

TEST_F(CostFile, thatCannotBeWrittenIsNoError) {
  const cost::MethodCosts costs = cost::costsOfThisMachine("/proc/no/costs.yaml");
  EXPECT_EQ(costs.all().size(), kWays);
}

TEST_F(CostFile, leavesNoTemporaryFile) {
  cost::costsOfThisMachine(file_);
  int files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(fs::path(file_).parent_path())) ++files;
  EXPECT_EQ(files, 1);
}

TEST(CostFilePlace, isTheEnvironmentsChoice) {
  setenv("POINSOT_COSTS", "/a/b.yaml", 1);
  EXPECT_EQ(cost::defaultCostFile(), "/a/b.yaml");
  unsetenv("POINSOT_COSTS");
  setenv("ROS_HOME", "/ros", 1);
  EXPECT_EQ(cost::defaultCostFile(), "/ros/poinsot/costs.yaml");
  unsetenv("ROS_HOME");
  setenv("HOME", "/home/x", 1);
  EXPECT_EQ(cost::defaultCostFile(), "/home/x/.ros/poinsot/costs.yaml");
}

TEST(NominalCosts, everyMethodHasOne) {
  const cost::MethodCosts& costs = cost::nominalCosts();
  EXPECT_EQ(costs.all().size(), kWays);
  EXPECT_EQ(costs.of(kClosedForm).per_step, 0);
  for (const Method& method : methods()) {
    EXPECT_GT(costs.of(method.name).per_step, 0) << method.name;
    EXPECT_GT(costs.of(method.name).per_state, 0) << method.name;
  }
  for (const TorqueMethod& method : torqueMethods()) {
    EXPECT_GT(costs.of(cost::torqueCostName(method.name)).per_step, 0) << method.name;
    EXPECT_GT(costs.of(cost::torqueCostName(method.name)).per_state, 0) << method.name;
  }
}

TEST(NominalCosts, nothingIsMeasuredWhereTheyAreGiven) {
  setenv("POINSOT_COSTS", "/tmp/poinsot_no_such_costs.yaml", 1);
  std::vector<std::string> sentences[2];
  for (auto& out : sentences) {
    scene::Scene scene = scene::readTree(
        YAML::Load("bodies: [{name: top, inertia: [1, 2, 3], angular_velocity: [0.3, 1, 0.2], method: stepper, "
                   "accuracy: 1e-7, horizon: 20}]"),
        "scene");
    out = cost::settleMethods(scene, 60, cost::nominalCosts());
    EXPECT_TRUE(scene.bodies[0].step);
  }
  EXPECT_EQ(sentences[0], sentences[1]);
  EXPECT_FALSE(fs::exists("/tmp/poinsot_no_such_costs.yaml"));
  unsetenv("POINSOT_COSTS");
}

}  // namespace
