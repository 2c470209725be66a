// Motions under torque, compared with closed formulas; see torque_cases.cpp for these and their sources.
#include <gtest/gtest.h>

#include <iomanip>
#include <iostream>
#include <sstream>

#include "cases.h"
#include "poinsot/core/method.h"
#include "poinsot/scene/motion_setup.h"
#include "poinsot/scene/reader.h"

namespace poinsot::validation {
namespace {

class UnderTorque : public testing::TestWithParam<Case> {};

std::string nameOf(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

TEST_P(UnderTorque, isWhatIsComputed) {
  const Case& one = GetParam();
  const std::vector<double> figures = one.measure(one.setup);
  for (const std::string& row : rows(one, figures)) std::cout << row << '\n';
  EXPECT_TRUE(agrees(one, figures));
}

// Not Taylor's series alone: rk4 shares nothing with it but the torques.
TEST_P(UnderTorque, isWhatOtherMethodsCompute) {
  const Case& one = GetParam();
  for (const auto& [method, part] : {std::pair<const char*, double>{"rk4", 0.005}, {"aba84", 0.1}, {"taylor24", 1.3}}) {
    MotionSetup other = one.setup;
    other.method = method;
    other.step = part * *one.setup.step;
    if (!objectionTo(*findMethod(method), sumOf(other.inertia, other.effects)).empty()) continue;
    SCOPED_TRACE(method);
    EXPECT_TRUE(agrees(one, one.measure(other)));
  }
}

std::string list(const Eigen::VectorXd& values) {
  std::ostringstream text;
  text << "[" << std::setprecision(17);
  for (int i = 0; i < values.size(); ++i) text << (i == 0 ? "" : ", ") << values[i];
  return text.str() + "]";
}

std::string number(double value) {
  std::ostringstream text;
  text << std::setprecision(17) << value;
  return text.str();
}

std::string written(const Effect& effect) {
  std::string keys;
  if (const auto* constant = std::get_if<ConstantTorque>(&effect)) {
    keys = "frame: " + std::string(constant->axes == Axes::body ? "body" : "world") +
           ", torque: " + list(constant->torque);
  } else if (const auto* gravity = std::get_if<GravityTorque>(&effect)) {
    keys = "mass: " + number(gravity->mass) + ", gravity: " + list(gravity->gravity) +
           ", centre_of_mass: " + list(gravity->centre_of_mass);
  } else if (const auto* gradient = std::get_if<GravityGradient>(&effect)) {
    keys = "orbit_rate: " + number(gradient->orbit_rate) + ", orbit_normal: " + list(gradient->orbit_normal) +
           ", radial_at_start: " + list(gradient->radial_at_start);
  } else if (const auto* viscous = std::get_if<ViscousDamping>(&effect)) {
    keys = "coefficient: " + list(viscous->coefficients);
  } else if (const auto* slug = std::get_if<InternalDissipation>(&effect)) {
    keys = "slug_inertia: " + number(slug->slug_inertia) + ", damping: " + number(slug->damping);
  }
  return "{type: " + nameOf(effect) + ", " + keys + "}";
}

// A scene with these numbers shows the same motion.
TEST_P(UnderTorque, isWhatASceneShows) {
  const Case& one = GetParam();
  const Eigen::Quaterniond& q = one.setup.attitude;
  const std::string text = "bodies: [{name: body, inertia: " + list(one.setup.inertia.moments()) +
                           ", attitude: " + list(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z())) +
                           ", angular_velocity: " + list(one.setup.omega_body) +
                           ", method: taylor20, step: " + number(*one.setup.step) + ", effects: [" +
                           written(one.setup.effects.at(0)) + "]}]";
  const scene::Scene read = scene::readTree(YAML::Load(text), one.name);
  EXPECT_TRUE(agrees(one, one.measure(scene::motionSetup(read.bodies.at(0)))));
}

// The claims do not hold for bodies with exchanged moments, nor for effects that are a tenth stronger.
TEST_P(UnderTorque, isNotWhatAnotherBodyShows) {
  const Case& one = GetParam();
  for (const auto& pair : one.swaps) {
    EXPECT_FALSE(agrees(one, one.measure(swapped(one.setup, pair)))) << "moments " << pair[0] << " and " << pair[1];
  }
  MotionSetup other = one.setup;
  for (Effect& effect : other.effects) {
    if (auto* e = std::get_if<ConstantTorque>(&effect)) e->torque *= 1.1;
    if (auto* e = std::get_if<GravityTorque>(&effect)) e->mass *= 1.1;
    if (auto* e = std::get_if<GravityGradient>(&effect)) e->orbit_rate *= 1.1;
    if (auto* e = std::get_if<ViscousDamping>(&effect)) e->coefficients *= 1.1;
    if (auto* e = std::get_if<InternalDissipation>(&effect)) e->damping = 0;  // where it ends it ends at any strength
  }
  EXPECT_FALSE(agrees(one, one.measure(other)));
}

INSTANTIATE_TEST_SUITE_P(Torque, UnderTorque, testing::ValuesIn(torqueCases()), nameOf);

}  // namespace
}  // namespace poinsot::validation
