// Bodies under torques: synthetic recordings, right ones and broken ones, for every effect.

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>
#include <sstream>

#include "poinsot/audit/effects.h"
#include "stream.h"

namespace poinsot::test {
namespace {

using audit::Options;
using audit::Report;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

const Quaterniond kTilted = Quaterniond(1, 2, 3, 4).normalized();
const char* const kEuler = "Euler's equations with torque";
const char* const kImpulse = "dL/dt = torque";
const char* const kPower = "dE/dt = power";

std::string print(const Report& report) {
  std::ostringstream out;
  out << report;
  return out.str();
}

void expectPass(const Report& report, const std::vector<std::string>& with) {
  EXPECT_TRUE(report.passed()) << print(report);
  for (const std::string& name : with) EXPECT_NE(report.find(name), nullptr) << name << "\n" << print(report);
}

/** Expects that these checks fail, perhaps with others. */
void expectFailures(const Report& report, const std::vector<std::string>& names, const char* words = "") {
  bool said = false;
  for (const audit::Check& check : report.failures()) {
    said = said || std::regex_search(check.detail, std::regex(words));
  }
  EXPECT_FALSE(report.passed());
  EXPECT_TRUE(said) << "nobody says \"" << words << "\"\n" << print(report);
  for (const std::string& name : names) {
    const audit::Check* check = report.find(name);
    EXPECT_TRUE(check && !check->passed) << "\"" << name << "\" should fail\n" << print(report);
  }
}

/** A body, the effects in its description, and the torques that do act on it. */
struct Scene {
  std::vector<std::string> effects;
  Driven driven;
  Vector3d moments{1, 2, 3}, omega{0.6, 1.1, -2.3};
  Quaterniond axes = Quaterniond::Identity(), attitude = kTilted;
  double described_slug = 0;  ///< J, in the messages' momentum
  int ticks = 120;
  double start = 0;
  std::string method = "rk4";

  Stream stream() const {
    BodySetup setup;
    setup.moments = moments;
    setup.axes = axes;
    setup.effects = effects;
    setup.method = method;
    setup.slug_inertia = described_slug;
    const Truth truth = drivenBody(setup.tensor(), attitude, omega, driven);
    return {setup, truth, steadily(ticks, start)};
  }
  Report judged() const { return stream().judged(); }

  Scene by(double factor) const {
    Scene out = *this;
    out.driven.torque = [factor, torque = driven.torque](double t, const Moment& m) {
      return Vector3d(factor * torque(t, m));
    };
    return out;
  }
};

/** Faults of a torque of any kind: 1 % too strong, wrong in sign, missing, not described. */
void expectWrongOnesCaught(const Scene& scene) {
  {
    SCOPED_TRACE("1 % too strong");
    expectFailures(scene.by(1.01).judged(), {"one motion: omega"}, "omega of the motion that begins with");
  }
  {
    SCOPED_TRACE("wrong sign");
    expectFailures(scene.by(-1).judged(), {kEuler, kImpulse}, "Euler's equations with this inertia and these effects");
  }
  {
    SCOPED_TRACE("does not act");
    expectFailures(scene.by(0).judged(), {kEuler, kImpulse});
  }
  {
    SCOPED_TRACE("not described");
    Scene missing = scene;
    missing.effects.clear();
    expectFailures(missing.judged(), {"Euler's equations", "L conserved"});
  }
}

Vector3d inBody(const Moment& m, const Vector3d& world) {
  return m.attitude.conjugate() * world;
}

const Vector3d kTorque(0.1, -0.2, 0.4);

TEST(ConstantTorque, InWorldAxes) {
  Scene scene;
  scene.effects = {"constant_torque: frame world, torque [0.10000000000000001, -0.20000000000000001, 0.4]"};
  scene.driven.torque = [](double, const Moment& m) { return inBody(m, kTorque); };
  expectPass(scene.judged(), {"L = L0 + torque t", kEuler, kImpulse, kPower, "one motion: attitude"});
  EXPECT_EQ(scene.judged().find("E conserved"), nullptr);
  EXPECT_LT(scene.judged().find("L = L0 + torque t")->bound, 1e-9);
  expectWrongOnesCaught(scene);
  expectFailures(scene.by(1.01).judged(), {"L = L0 + torque t"}, "L, less the torques' impulse, changes by");

  Scene other = scene;
  other.driven.torque = [](double, const Moment&) { return kTorque; };
  expectFailures(other.judged(), {kEuler, kImpulse, kPower, "L = L0 + torque t"});
}

TEST(ConstantTorque, InBodyAxesThatAreNotPrincipalFromRest) {
  Scene scene;
  scene.axes = Quaterniond(0.3, -0.4, 0.7, 0.1).normalized();
  scene.omega.setZero();
  scene.effects = {"constant_torque: frame body, torque [0.1, -0.2, 0.4]"};
  scene.driven.torque = [](double, const Moment&) { return kTorque; };
  expectPass(scene.judged(), {kEuler, kImpulse, kPower});
  EXPECT_EQ(scene.judged().find("L = L0 + torque t"), nullptr);
  expectWrongOnesCaught(scene);

  Scene other = scene;
  other.driven.torque = [](double, const Moment& m) { return inBody(m, kTorque); };
  expectFailures(other.judged(), {kEuler, kImpulse});
}

TEST(GravityTorque, AsymmetricHeavyTop) {
  const Vector3d force(0, 0.5, -1.5 * 9.81), centre(0.05, -0.1, 0.3);
  Scene scene;
  scene.effects = {
      "gravity_torque: mass 1.5, gravity [0, 0.33333333333333331, -9.8100000000000005], "
      "centre_of_mass [0.05, -0.1, 0.3]"};
  scene.driven.torque = [=](double, const Moment& m) { return Vector3d(centre.cross(inBody(m, force))); };
  expectPass(scene.judged(), {"E - m g.Rc conserved", "L along g conserved", kEuler, kImpulse, kPower});
  EXPECT_EQ(scene.judged().find("L along the top's axis conserved"), nullptr);
  expectWrongOnesCaught(scene);
  expectFailures(scene.by(1.01).judged(), {"E - m g.Rc conserved"}, "E - m g.Rc changes by");

  Scene other = scene;
  other.driven.torque = [=](double, const Moment&) { return Vector3d(centre.cross(force)); };
  expectFailures(other.judged(), {kEuler, kImpulse, "E - m g.Rc conserved", "L along g conserved"});
}

TEST(GravityTorque, SymmetricTop) {
  const Vector3d force(0, 0, -20), centre(0, 0, 0.25);
  Scene scene;
  scene.moments = {2, 2, 1};
  scene.omega = {0.3, 0.1, 15};
  scene.attitude = Quaterniond(1, 0.3, 0, 0).normalized();
  scene.effects = {"gravity_torque: mass 2, gravity [0, 0, -10], centre_of_mass [0, 0, 0.25]"};
  scene.driven.torque = [=](double, const Moment& m) { return Vector3d(centre.cross(inBody(m, force))); };
  expectPass(scene.judged(), {"L along the top's axis conserved", "E - m g.Rc conserved", "L along g conserved"});

  // A torque about its axis, which no weight has.
  Scene spun = scene;
  spun.driven.torque = [=](double, const Moment& m) {
    return Vector3d(centre.cross(inBody(m, force)) + Vector3d(0, 0, 1e-6));
  };
  expectFailures(spun.judged(), {"L along the top's axis conserved", "one motion: omega"});
}

TEST(GravityGradient, SlowSatellite) {
  const double n = 0.0011;
  Scene scene;
  scene.moments = {10, 12, 4};
  scene.omega = {0.0004, 0.0011, 0.0002};
  scene.attitude = Quaterniond(1, 0.2, 0.3, 0.1).normalized();
  scene.ticks = 300;
  scene.effects = {
      "gravity_gradient: orbit_rate 0.0011000000000000001, orbit_normal [0, 2, 0], "
      "radial_at_start [0, 0, 3]"};
  const auto radial = [n](double t) { return Vector3d(std::sin(n * t), 0, std::cos(n * t)); };
  const Matrix3d tensor = scene.moments.asDiagonal();
  const auto torque = [=](const Vector3d& u) { return Vector3d(3 * n * n * u.cross(tensor * u)); };
  scene.driven.torque = [=](double t, const Moment& m) { return torque(inBody(m, radial(t))); };
  expectPass(scene.judged(), {"E - n N.L + 3/2 n^2 u'Mu conserved", kEuler, kImpulse, kPower});
  expectWrongOnesCaught(scene);

  Scene other = scene;  // r as if it were given in body axes
  other.driven.torque = [=](double t, const Moment&) { return torque(radial(t)); };
  expectFailures(other.judged(), {kEuler, kImpulse, "E - n N.L + 3/2 n^2 u'Mu conserved"});
  other.driven.torque = [=](double t, const Moment& m) { return torque(inBody(m, radial(-t))); };
  expectFailures(other.judged(), {"one motion: omega"});
}

TEST(GravityGradient, FastOrbit) {
  const double n = 0.5;
  Scene scene;
  scene.effects = {"gravity_gradient: orbit_rate 0.5, orbit_normal [0, 1, 0], radial_at_start [0, 0, 1]"};
  const Matrix3d tensor = scene.moments.asDiagonal();
  scene.driven.torque = [=](double t, const Moment& m) {
    const Vector3d u = inBody(m, {std::sin(n * t), 0, std::cos(n * t)});
    return Vector3d(3 * n * n * u.cross(tensor * u));
  };
  expectPass(scene.judged(), {"E - n N.L + 3/2 n^2 u'Mu conserved"});
  scene.start = 5;
  expectPass(scene.judged(), {"E - n N.L + 3/2 n^2 u'Mu conserved"});
  expectWrongOnesCaught(scene);
  expectFailures(scene.by(1.01).judged(), {"E - n N.L + 3/2 n^2 u'Mu conserved"});
}

TEST(ViscousDamping, PerAxisAndIsotropic) {
  for (const bool isotropic : {false, true}) {
    SCOPED_TRACE(isotropic);
    const Vector3d c = isotropic ? Vector3d(0.2, 0.2, 0.2) : Vector3d(0.1, 0.2, 0.05);
    Scene scene;
    scene.axes = Quaterniond(0.3, -0.4, 0.7, 0.1).normalized();
    scene.effects = {isotropic ? "viscous_damping: coefficient 0.2" : "viscous_damping: coefficient [0.1, 0.2, 0.05]"};
    scene.driven.torque = [=](double, const Moment& m) { return Vector3d(-c.cwiseProduct(m.omega_body)); };
    expectPass(scene.judged(), {"E never rises", kEuler, kImpulse, kPower});
    expectWrongOnesCaught(scene);
    expectFailures(scene.by(-1).judged(), {"E never rises", kPower}, "energy rises although nothing but damping acts");
    if (isotropic) continue;
    Scene other = scene;  // along principal axes instead of body axes
    const Quaterniond axes = scene.axes;
    other.driven.torque = [=](double, const Moment& m) {
      return Vector3d(axes * -c.cwiseProduct(axes.conjugate() * m.omega_body));
    };
    expectFailures(other.judged(), {kEuler, kImpulse, kPower});
  }
}

TEST(TorqueSchedule, SwitchesBetweenMessages) {
  Scene scene;
  scene.effects = {
      "torque_schedule: from 0.50309999999999999, to 1.2070000000000001, frame body, torque [0, 0.1, -1]; "
      "from 1.3009999999999999, to 1.302, frame world, torque [3, 0, 0]"};
  const auto torque = [](double t, const Moment& m, double late) {
    if (t >= 0.5031 + late && t < 1.207) return Vector3d(0, 0.1, -1);
    return t >= 1.301 && t < 1.302 ? inBody(m, {3, 0, 0}) : Vector3d(0, 0, 0);
  };
  scene.driven.torque = [torque](double t, const Moment& m) { return torque(t, m, 0); };
  scene.driven.switches = {0.5031, 1.207, 1.301, 1.302};
  expectPass(scene.judged(), {kEuler, kImpulse, kPower});
  expectWrongOnesCaught(scene);

  Scene late = scene;  // by a tenth of a millisecond
  late.driven.torque = [torque](double t, const Moment& m) { return torque(t, m, 1e-4); };
  late.driven.switches[0] += 1e-4;
  expectFailures(late.judged(), {kEuler, kImpulse, kPower});

  Scene swapped = scene;
  swapped.effects = {
      "torque_schedule: from 0.50309999999999999, to 1.2070000000000001, frame world, torque [0, 0.1, -1]; "
      "from 1.3009999999999999, to 1.302, frame body, torque [3, 0, 0]"};
  expectFailures(swapped.judged(), {kEuler, kImpulse});
}

Scene withSlug() {
  Scene scene;
  scene.moments = {1, 5, 6};
  scene.omega = {4, 0.3, 0.1};
  scene.effects = {"internal_dissipation: slug_inertia 0.29999999999999999, damping 0.5"};
  scene.described_slug = 0.3;
  scene.driven.slug_inertia = 0.3;
  scene.driven.slug_damping = 0.5;
  return scene;
}

TEST(InternalDissipation, Right) {
  const Report report = withSlug().judged();
  expectPass(report, {"L conserved", "E never rises", "slug's equation", "slug starts with the body", kEuler, kPower});
  EXPECT_LT(report.find("L conserved")->bound, 1e-8);
  Scene later = withSlug();
  later.start = 1;
  expectPass(later.judged(), {"L conserved", "slug's equation"});
  EXPECT_EQ(later.judged().find("slug starts with the body"), nullptr);
}

TEST(InternalDissipation, Wrong) {
  Scene scene = withSlug();
  scene.driven.slug_damping = 0.505;
  expectFailures(scene.judged(), {kEuler, "slug's equation", "one motion: omega"});
  scene = withSlug();
  scene.driven.slug_damping = -0.5;
  expectFailures(scene.judged(), {kEuler, "slug's equation", "E never rises"});
  scene = withSlug();
  scene.driven.slug_damping = 0;  // energy does not fall
  expectFailures(scene.judged(), {kEuler, kPower});
  scene = withSlug();
  scene.driven.slug_at_rest = true;
  expectFailures(scene.judged(), {"slug starts with the body"}, "at t = 0 momentum_world is not R \\(M \\+ J\\)");
  scene = withSlug();
  scene.driven.slug_turned = false;
  expectFailures(scene.judged(), {"slug's equation", "L conserved"}, "L, less the torques' impulse, changes by");
  scene = withSlug();
  scene.driven.torque = [](double, const Moment&) { return Vector3d(0, 0, 1e-6); };  // L drifts
  expectFailures(scene.judged(), {"L conserved", kImpulse});
  scene = withSlug();
  scene.described_slug = 0.303;
  expectFailures(scene.judged(), {"slug starts with the body"});
  scene = withSlug();
  scene.described_slug = 0;  // momentum_world of the body alone
  expectFailures(scene.judged(), {"slug starts with the body", "L conserved", "slug's equation"});
  scene = withSlug();
  scene.effects.clear();
  expectFailures(scene.judged(), {"E conserved", "momentum_world = R M omega_body"});
}

TEST(Several, AddUp) {
  const double n = 0.5;
  Scene scene = withSlug();
  scene.effects.insert(scene.effects.begin(),
                       "translation: position [0, 0, 0], velocity [0, 0, 0], "
                       "acceleration [0, 0, 0]");
  scene.effects.push_back("viscous_damping: coefficient [0.1, 0.2, 0.3]");
  scene.effects.push_back("gravity_gradient: orbit_rate 0.5, orbit_normal [0, 1, 0], radial_at_start [0, 0, 1]");
  scene.effects.push_back("constant_torque: frame body, torque [0.1, -0.2, 0.4]");
  const Matrix3d tensor = scene.moments.asDiagonal();
  scene.driven.torque = [=](double t, const Moment& m) {
    const Vector3d u = inBody(m, {std::sin(n * t), 0, std::cos(n * t)});
    return Vector3d(3 * n * n * u.cross(tensor * u) + kTorque - Vector3d(0.1, 0.2, 0.3).cwiseProduct(m.omega_body));
  };
  expectPass(scene.judged(), {kEuler, kImpulse, kPower, "slug's equation"});
  for (std::size_t i = 1; i < scene.effects.size(); ++i) {
    SCOPED_TRACE(scene.effects[i]);
    Scene missing = scene;
    missing.effects.erase(missing.effects.begin() + static_cast<std::ptrdiff_t>(i));
    expectFailures(missing.judged(), {kEuler});
  }
}

TEST(Fields, AttitudeErrorIsNaNUnderTorques) {
  Stream stream = withSlug().stream();
  stream.states[10].attitude_error = 0;
  expectFailures(stream.judged(), {"attitude_error"},
                 "attitude_error: expected NaN under torques, without a closed form, got ");
}

TEST(Fields, Drifts) {
  Stream stream = withSlug().stream();
  stream.states[10].momentum_drift += 1e-9;
  expectFailures(stream.judged(), {"energy_drift and momentum_drift"}, "momentum_drift says");
}

TEST(Fields, TimeRate) {
  Stream stream = withSlug().stream();
  for (BodyState& s : stream.states) s.time_rate = 1.01;
  expectFailures(stream.judged(), {"time advances by time_rate", "dR/dstamp = time_rate R hat(omega)"},
                 "R turns 0\\.99.. times as far");
}

TEST(Fields, MethodsThatDoNotFit) {
  Scene scene = withSlug();
  scene.method = "closed_form";
  expectFailures(scene.judged(), {"effects"}, "closed_form moves only free bodies, but the description names torques");
  Scene free;
  free.method = "taylor16";
  expectFailures(free.judged(), {"effects"}, "method taylor16 needs torques, but the description names none");
}

TEST(Fields, PauseAndBackwards) {
  std::vector<Tick> ticks = steadily(200);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    ticks[i].time_rate = i < 100 ? 1 : i < 130 ? 0 : -1.25;
    if (i > 0) {
      ticks[i].time =
          ticks[i - 1].time + ticks[i - 1].time_rate * 1e-9 * static_cast<double>(ticks[i].stamp - ticks[i - 1].stamp);
    }
  }
  BodySetup setup;
  setup.effects = {"viscous_damping: coefficient 0.2"};
  Driven driven;
  driven.torque = [](double, const Moment& m) { return Vector3d(-0.2 * m.omega_body); };
  // Forwards only: each time from the start again.
  const Truth truth = [&](double t) { return drivenBody(setup.tensor(), kTilted, {0.6, 1.1, -2.3}, driven, 1e-3)(t); };
  setup.step = 1e-3;
  expectPass(Stream(setup, truth, ticks).judged(), {"E never rises", kEuler, "one motion: omega"});
}

TEST(Markers, EllipsoidsOfTheMoment) {
  const Stream right = withSlug().stream();
  expectPass(right.judged(), {"energy ellipsoid (space)", "momentum ellipsoid (model)"});
  EXPECT_GE(right.judged().find("energy ellipsoid (model)")->count, 120);

  Stream still = right;  // as at the start, for ever
  for (auto& message : still.markers) {
    for (std::size_t i = 2; i < message.markers.size(); ++i) {
      message.markers[i].scale = right.markers[0].markers[i].scale;
    }
  }
  expectFailures(still.judged(),
                 {"energy ellipsoid (space)", "momentum ellipsoid (model)", "omega on both ellipsoids (model)"});
  Stream one_missing = right;
  one_missing.markers[50].markers.erase(one_missing.markers[50].markers.begin() + 2);
  expectFailures(one_missing.judged(), {"energy ellipsoid (space)"}, "1 states between others have no ellipsoid");
  Stream fixed = right;
  for (auto& message : fixed.markers) {
    for (std::size_t i = 2; i < message.markers.size(); ++i) fixed.markers_static.markers.push_back(message.markers[i]);
    message.markers.resize(2);
    break;
  }
  for (auto& marker : fixed.markers_static.markers) marker.header.stamp = ros::Time();
  expectFailures(fixed.judged(), {"energy ellipsoid (space)"},
                 "an ellipsoid does not change although the body's energy and momentum do");
}

TEST(Texts, CannotBeRead) {
  const auto says = [](const std::string& text, const char* why) {
    const std::string problem = audit::readEffects({text}).problem;
    EXPECT_TRUE(std::regex_search(problem, std::regex(why))) << problem;
  };
  says("magnetism: field [0, 0, 1]", "\"magnetism: field \\[0, 0, 1\\]\" cannot be read: unknown type \"magnetism\"");
  says("constant_torque", "expected \"type: \" at the start");
  says("constant_torque: frame world", "key \"torque\" is missing");
  says("constant_torque: frame orbit, torque [0, 0, 1]", "frame: expected body or world, got \"orbit\"");
  says("constant_torque: frame body, torque [0, 0, nan]", "expected a finite number, got \"nan\"");
  says("constant_torque: frame body, torque [0, 0]", "expected \\[x, y, z\\], got \"\\[0, 0\\]\"");
  says("constant_torque: frame body, torque [0, 0, 1], until 3", "unknown key \"until\"");
  says("constant_torque: frame body, frame body, torque [0, 0, 1]", "key \"frame\" is given twice");
  says("viscous_damping: coefficient -1", "coefficient: expected at least 0, got -1");
  says("gravity_gradient: orbit_rate 1, orbit_normal [0, 0, 1], radial_at_start [0, 1, 1]",
       "orbit_normal and radial_at_start are not perpendicular");
  says("torque_schedule: from 2, to 1, frame body, torque [0, 0, 1]",
       "to: expected a time after from \\(2 s\\), got 1 s");
  says("internal_dissipation: slug_inertia 0, damping 1", "slug_inertia: expected a positive number, got 0");
  EXPECT_EQ(audit::readEffects({"viscous_damping: coefficient [0.1, 0.2, 1e-3]"}).problem, "");

  Scene scene = withSlug();
  scene.effects.push_back("magnetism: field [0, 0, 1]");
  expectFailures(scene.judged(), {"effects"}, "unknown type");
}

// What an effect that cannot be read says nothing of is judged all the same.
TEST(Texts, OneThatCannotBeReadHidesNothingElse) {
  Scene free;
  free.effects = {"translation: position [0, 0, 0]"};  // the other keys are missing
  EXPECT_TRUE(free.judged().find("Euler's equations")) << "the rotation of a free body is known";
  EXPECT_FALSE(free.judged().find("position and velocity"));
  free.driven.torque = [](double, const Moment&) { return Vector3d(0, 0, 0.1); };
  expectFailures(free.judged(), {"effects", "Euler's equations", "L conserved"});

  Scene driven = withSlug();
  driven.effects.push_back("magnetism: field [0, 0, 1]");
  EXPECT_FALSE(driven.judged().find("Euler's equations with torque"));
  EXPECT_TRUE(driven.judged().find("position and velocity")) << "a translation would be read";
}

TEST(Texts, TranslationIsThatOfTheDescription) {
  Scene scene;
  scene.effects = {"translation: position [0, 0, 1e-6], velocity [0, 0, 0], acceleration [0, 0, 0]"};
  expectFailures(scene.judged(), {"position and velocity"}, "position is not what the description's translation says");
}

}  // namespace
}  // namespace poinsot::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
