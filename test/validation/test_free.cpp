// Motions without torque, held to published numbers; see free_cases.cpp for these and their sources.
#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "cases.h"
#include "poinsot/core/method.h"
#include "poinsot/scene/motion_setup.h"
#include "poinsot/scene/reader.h"

namespace poinsot::validation {
namespace {

class Published : public testing::TestWithParam<Case> {};

std::string nameOf(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

TEST_P(Published, isWhatIsComputed) {
  const Case& one = GetParam();
  const std::vector<double> figures = one.measure(one.setup);
  for (const std::string& row : rows(one, figures)) std::cout << row << '\n';
  EXPECT_TRUE(agrees(one, figures));
}

// Not the closed form alone: two steppers that share no formula with it.
TEST_P(Published, isWhatSteppersCompute) {
  const Case& one = GetParam();
  const Eigen::Vector3d moments = one.setup.inertia.moments();
  const double rate = moments.cwiseProduct(one.setup.omega_body).norm() / moments.minCoeff();
  for (const auto& [method, turn] : {std::pair<const char*, double>{"rk4", 0.002}, {"dmv10", 0.05}}) {
    if (one.feels_rounding && !findMethod(method)->conserves_energy) continue;
    SCOPED_TRACE(method);
    MotionSetup stepped = one.setup;
    stepped.method = method;
    stepped.step = turn / rate;
    EXPECT_TRUE(agrees(one, one.measure(stepped)));
  }
}

// A scene with these numbers shows the same motion.
TEST_P(Published, isWhatASceneShows) {
  const Case& one = GetParam();
  std::ostringstream text;
  const auto list = [&text](const char* key, const Eigen::VectorXd& values) {
    text << "    " << key << ": [" << std::setprecision(17);
    for (int i = 0; i < values.size(); ++i) text << (i == 0 ? "" : ", ") << values[i];
    text << "]\n";
  };
  const Eigen::Quaterniond& q = one.setup.attitude;
  text << "bodies:\n  - name: body\n";
  list("inertia", one.setup.inertia.moments());
  list("attitude", Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()));
  list("angular_velocity", one.setup.omega_body);
  const scene::Scene read = scene::readTree(YAML::Load(text.str()), one.name);
  EXPECT_TRUE(agrees(one, one.measure(scene::motionSetup(read.bodies.at(0)))));
}

// The claims do not hold for bodies with exchanged moments.
TEST_P(Published, isNotWhatABodyWithMomentsExchangedShows) {
  const Case& one = GetParam();
  for (const auto& pair : one.swaps) {
    EXPECT_FALSE(agrees(one, one.measure(swapped(one.setup, pair)))) << "moments " << pair[0] << " and " << pair[1];
  }
}

// Figures that the closed form gives directly agree with those of trajectories.
class Said : public Published {};

TEST_P(Said, byTheClosedFormAgreesWithItsTrajectory) {
  const Case& one = GetParam();
  const ClosedForm form(one.setup.inertia.moments(), one.setup.attitude, one.setup.omega_body);
  const std::vector<double> measured = one.measure(one.setup), said = one.say(form);
  ASSERT_EQ(measured.size(), said.size());
  EXPECT_TRUE(std::isfinite(said[0]));
  for (std::size_t i = 0; i < said.size(); ++i) {
    if (!std::isfinite(said[i])) continue;
    EXPECT_NEAR(said[i], measured[i], 1e-11 * std::abs(said[i])) << "figure " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Free, Published, testing::ValuesIn(freeCases()), nameOf);

std::vector<Case> casesThatSay() {
  std::vector<Case> some;
  for (const Case& one : freeCases()) {
    if (one.say) some.push_back(one);
  }
  return some;
}

INSTANTIATE_TEST_SUITE_P(Free, Said, testing::ValuesIn(casesThatSay()), nameOf);

const Case& freeCase(const std::string& name) {
  for (const Case& one : freeCases()) {
    if (one.name == name) return one;
  }
  throw std::out_of_range(name);
}

// Principia's check of the spacing can fail: lie_euler gains energy, and the flips come at other times.
TEST(Principia, flipsUnderAMethodThatGainsEnergyAreNotEquallySpaced) {
  const Case& one = freeCase("principia");
  MotionSetup drifting = one.setup;
  drifting.method = "lie_euler";
  drifting.step = 0.01;
  const std::vector<double> figures = one.measure(drifting);
  EXPECT_FALSE(agrees(one.claims.at(0), figures.at(0)));
  EXPECT_FALSE(agrees(one.claims.at(1), figures.at(1)));
}

// Nor does the Euler period hide its sense: the pole of a body longer than wide goes round the other way.
TEST(Earth, aProlateOneWobblesBackwards) {
  const Case& one = freeCase("earth");
  MotionSetup prolate = one.setup;
  const double h = 1 - one.setup.inertia.moments()[0];
  prolate.inertia = PrincipalInertia::fromMoments({1 + h, 1 + h, 1});
  EXPECT_NEAR(one.measure(prolate).at(0), -(1 + h) / h, 1e-6);
}

// Pravec et al. 2014: P_ψ = 263 h, P_φ = 27.38 h. An interval, not an equality.
TEST(Apophis, theObservedRatioOfPeriodsLiesInTheIntervalOfItsInertia) {
  const auto ratio = [](const char* name) { return freeCase(name).measure(freeCase(name).setup).at(0); };
  const double observed = 263 / 27.38;
  EXPECT_NEAR(observed, 9.61, 0.005);
  EXPECT_LT(ratio("apophis_low"), observed);
  EXPECT_LT(observed, ratio("apophis_high"));
}

}  // namespace
}  // namespace poinsot::validation
