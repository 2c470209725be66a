#include <algorithm>
#include <map>

#include "poinsot/core/method.h"
#include "scene_text.h"

using namespace poinsot;
using scene_text::expectKeyRefused;
using scene_text::readBody;

namespace {

template <class Type>
Type only(const scene::Body& body) {
  EXPECT_EQ(body.effects.size(), 1u);
  return std::get<Type>(body.effects.at(0));
}

/** `effects: [{type: …, …}]` of the keys given; with one of them replaced, or left out where it is "". */
using Keys = std::vector<std::pair<std::string, std::string>>;
std::string effect(const std::string& type, Keys keys, const std::string& key = "", const std::string& value = "") {
  std::string text = "effects: [{type: " + type;
  for (const auto& [name, given] : keys) {
    if (name != key) text += ", " + name + ": " + given;
  }
  if (!value.empty()) text += ", " + key + ": " + value;
  return text + "}]";
}

const std::map<std::string, Keys>& types() {
  static const std::map<std::string, Keys> all = {
      {"constant_torque", {{"frame", "body"}, {"torque", "[0, 0, 1]"}}},
      {"gravity_torque", {{"mass", "2"}, {"gravity", "[0, 0, -9]"}, {"centre_of_mass", "[0, 0, 1]"}}},
      {"gravity_gradient", {{"orbit_rate", "1"}, {"orbit_normal", "[0, 0, 2]"}, {"radial_at_start", "[3, 0, 0]"}}},
      {"viscous_damping", {{"coefficient", "0.5"}}},
      {"internal_dissipation", {{"slug_inertia", "0.1"}, {"damping", "0.2"}}},
      {"torque_schedule", {{"segments", "[{from: 1, to: 2, frame: body, torque: [0, 0, 1]}]"}}}};
  return all;
}

}  // namespace

TEST(Effects, TranslationDefaultsToRest) {
  const auto still = readBody({"effects: [{type: translation}]"});
  ASSERT_TRUE(still.translation);
  EXPECT_TRUE(still.translation->position.isZero(0));
  EXPECT_TRUE(still.translation->velocity.isZero(0));
  EXPECT_TRUE(still.translation->acceleration.isZero(0));

  const auto falling = readBody({"effects:", "  - type: translation", "    acceleration: [0, 0, -9.81]"});
  ASSERT_TRUE(falling.translation);
  EXPECT_EQ(falling.translation->acceleration, Eigen::Vector3d(0, 0, -9.81));
  EXPECT_TRUE(falling.translation->velocity.isZero(0));
  EXPECT_FALSE(readBody({"effects: []"}).translation);
}

TEST(Effects, BadTranslationsAreRefused) {
  expectKeyRefused("effects: [{type: translation, position: [1, 2]}]", ".effects[0].position",
                   {"got a list of 2$", "expected a list of 3 finite numbers (m)"});
  expectKeyRefused("effects: [{type: translation, velocity: [1, x, 2]}]", ".effects[0].velocity[1]",
                   {"got \"x\": not a decimal number$", "expected a finite number (m/s)"});
  expectKeyRefused("effects: [{type: translation, acceleration: [.nan, 0, 2]}]", ".effects[0].acceleration[0]",
                   {"got .nan$", "expected a finite number (m/s²)"});
  expectKeyRefused("effects: [{type: translation, mass: 1}]", ".effects[0].mass",
                   {"got \"mass\"$", "expected one of the keys type, position, velocity, acceleration, got"});
  expectKeyRefused("effects: [{type: translation}, {type: translation}]", ".effects[1]",
                   {"got a second$", "expected one translation per body"});
}

TEST(Effects, UnknownTypesAreRefused) {
  const std::string all =
      "expected one of translation, constant_torque, gravity_torque, gravity_gradient, viscous_damping, "
      "internal_dissipation, torque_schedule, got";
  expectKeyRefused("effects: [{type: magnetism}]", ".effects[0].type", {"got \"magnetism\"$", all});
  expectKeyRefused("effects: [{type: transaltion}]", ".effects[0].type", {" (did you mean \"translation\"?)$", all});
  expectKeyRefused("effects: [{type: gravity_torqe}]", ".effects[0].type",
                   {" (did you mean \"gravity_torque\"?)$", all});
}

TEST(Effects, AreAListOfMapsWithAType) {
  expectKeyRefused("effects: {type: translation}", ".effects", {"got a map$", "a list of effects"});
  expectKeyRefused("effects:", ".effects", {"got null$", "a list of effects"});
  expectKeyRefused("effects: [translation]", ".effects[0]", {"got \"translation\"$", "expected an effect"});
  expectKeyRefused("effects: [{position: [0, 0, 0]}]", ".effects[0]", {"expected the key type, ", "translation"});
}

TEST(Effects, EveryKeyIsRead) {
  const auto torque =
      only<ConstantTorque>(readBody({"effects: [{type: constant_torque, frame: world, torque: [1e-3, \"2\", -3]}]"}));
  EXPECT_EQ(torque.axes, Axes::world);
  EXPECT_EQ(torque.torque, Eigen::Vector3d(1e-3, 2, -3));
  EXPECT_EQ(only<ConstantTorque>(readBody({effect("constant_torque", types().at("constant_torque"))})).axes,
            Axes::body);

  const auto weight = only<GravityTorque>(readBody({effect("gravity_torque", types().at("gravity_torque"))}));
  EXPECT_EQ(weight.mass, 2);
  EXPECT_EQ(weight.gravity, Eigen::Vector3d(0, 0, -9));
  EXPECT_EQ(weight.centre_of_mass, Eigen::Vector3d(0, 0, 1));
  const auto here = only<GravityTorque>(readBody({effect("gravity_torque", types().at("gravity_torque"), "gravity")}));
  EXPECT_EQ(here.gravity, Eigen::Vector3d(0, 0, -9.80665));

  const auto orbit = only<GravityGradient>(readBody({effect("gravity_gradient", types().at("gravity_gradient"))}));
  EXPECT_EQ(orbit.orbit_rate, 1);
  EXPECT_EQ(orbit.orbit_normal, Eigen::Vector3d(0, 0, 2));
  EXPECT_EQ(orbit.radial_at_start, Eigen::Vector3d(3, 0, 0));

  const auto one = only<ViscousDamping>(readBody({effect("viscous_damping", types().at("viscous_damping"))}));
  EXPECT_EQ(one.coefficients, Eigen::Vector3d(0.5, 0.5, 0.5));
  const auto three = only<ViscousDamping>(readBody({"effects: [{type: viscous_damping, coefficient: [0, 1, 2]}]"}));
  EXPECT_EQ(three.coefficients, Eigen::Vector3d(0, 1, 2));

  const auto slug =
      only<InternalDissipation>(readBody({effect("internal_dissipation", types().at("internal_dissipation"))}));
  EXPECT_EQ(slug.slug_inertia, 0.1);
  EXPECT_EQ(slug.damping, 0.2);

  const auto schedule =
      only<TorqueSchedule>(readBody({"effects:", "  - type: torque_schedule",
                                     "    segments:", "      - {from: -1, to: 1.5, frame: body, torque: [1, 2, 3]}",
                                     "      - {from: 1.5, to: 1e3, frame: world, torque: [4, 5, 6]}"}));
  ASSERT_EQ(schedule.segments.size(), 2u);
  EXPECT_EQ(schedule.segments[0].from, -1);
  EXPECT_EQ(schedule.segments[0].to, 1.5);
  EXPECT_EQ(schedule.segments[0].axes, Axes::body);
  EXPECT_EQ(schedule.segments[0].torque, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(schedule.segments[1].to, 1000);
  EXPECT_EQ(schedule.segments[1].axes, Axes::world);
}

TEST(Effects, SeveralAddUpInTheOrderGiven) {
  const auto body =
      readBody({"effects:", "  - {type: viscous_damping, coefficient: 1}",
                "  - {type: constant_torque, frame: body, torque: [1, 0, 0]}",
                "  - {type: constant_torque, frame: world, torque: [0, 1, 0]}",
                "  - {type: translation, velocity: [1, 0, 0]}", "  - {type: viscous_damping, coefficient: [0, 0, 1]}"});
  ASSERT_EQ(body.effects.size(), 4u);
  EXPECT_EQ(nameOf(body.effects[0]), "viscous_damping");
  EXPECT_EQ(nameOf(body.effects[2]), "constant_torque");
  EXPECT_TRUE(body.translation);
}

TEST(Effects, EveryKeyIsRequiredButGravity) {
  for (const auto& [type, keys] : types()) {
    for (const auto& [key, value] : keys) {
      if (key == "gravity") continue;
      expectKeyRefused(effect(type, keys, key), ".effects[0]", {"expected the key " + key + ", ", "got none$"});
    }
  }
}

TEST(Effects, UnknownKeysAreRefused) {
  for (const auto& [type, keys] : types()) {
    std::string expected = "expected one of the keys type";
    for (const auto& [key, value] : keys) expected += ", " + key;
    expectKeyRefused(effect(type, keys, "colour", "red"), ".effects[0].colour",
                     {"got \"colour\"$", expected + ", got"});
  }
  expectKeyRefused(effect("viscous_damping", {}, "coeficient", "1"), ".effects[0].coeficient",
                   {" (did you mean \"coefficient\"?)$"});
  expectKeyRefused(
      "effects: [{type: torque_schedule, segments: [{from: 0, to: 1, frame: body, torque: [0, 0, 1], ramp: 1}]}]",
      ".effects[0].segments[0].ramp",
      {"got \"ramp\" (did you mean \"frame\"?)$", "expected one of the keys from, to, frame, torque, got"});
}

TEST(Effects, WhatIsNoFiniteNumberIsRefused) {
  for (const auto& [type, keys] : types()) {
    for (const auto& [key, value] : keys) {
      if (key == "frame" || key == "segments") continue;
      const bool list = value[0] == '[';
      for (const std::string bad : {".nan", ".inf", "-.inf", "1e999", "x"}) {
        if (list) {
          expectKeyRefused(effect(type, keys, key, "[0, " + bad + ", 1]"), ".effects[0]." + key + "[1]",
                           {"got ", bad, "expected a finite number"});
        } else {
          expectKeyRefused(effect(type, keys, key, bad), ".effects[0]." + key, {bad, "expected a "});
        }
      }
      if (list) {
        expectKeyRefused(effect(type, keys, key, "[1, 2]"), ".effects[0]." + key, {"got a list of 2$"});
        expectKeyRefused(effect(type, keys, key, "[1, 2, 3, 4]"), ".effects[0]." + key, {"got a list of 4$"});
        expectKeyRefused(effect(type, keys, key, "3"), ".effects[0]." + key, {"got 3$"});
      }
    }
  }
  for (const std::string bad : {".nan", ".inf"}) {
    expectKeyRefused(
        "effects: [{type: torque_schedule, segments: [{from: " + bad + ", to: 1, frame: body, torque: [0, 0, 1]}]}]",
        ".effects[0].segments[0].from", {"got " + bad + "$", "expected a finite number (s)"});
    expectKeyRefused(
        "effects: [{type: torque_schedule, segments: [{from: 0, to: 1, frame: body, torque: [0, 0, " + bad + "]}]}]",
        ".effects[0].segments[0].torque[2]", {"got " + bad + "$", "expected a finite number (N·m)"});
  }
}

TEST(Effects, WhatIsOutOfItsRangeIsRefused) {
  const auto refused = [](const std::string& type, const std::string& key, const std::string& value,
                          const std::string& place, const std::vector<std::string>& pieces) {
    expectKeyRefused(effect(type, types().at(type), key, value), ".effects[0]" + place, pieces);
  };
  for (const std::string bad : {"0", "-1"}) {
    refused("gravity_torque", "mass", bad, ".mass", {"got " + bad + "$", "a positive finite number (kg)"});
    refused("gravity_gradient", "orbit_rate", bad, ".orbit_rate",
            {"got " + bad + "$", "a positive finite number (rad/s)"});
    refused("internal_dissipation", "slug_inertia", bad, ".slug_inertia",
            {"got " + bad + "$", "a positive finite number (kg·m²)"});
  }
  refused("internal_dissipation", "damping", "-0.1", ".damping", {"got -0.1$", "N·m·s"});
  refused("viscous_damping", "coefficient", "-0.1", ".coefficient", {"got -0.1$", "N·m·s"});
  refused("viscous_damping", "coefficient", "[0, 1, -1e-9]", ".coefficient[2]", {"got -1e-9$", "N·m·s"});
  EXPECT_NO_THROW(readBody({effect("internal_dissipation", types().at("internal_dissipation"), "damping", "0")}));
  EXPECT_NO_THROW(readBody({effect("viscous_damping", types().at("viscous_damping"), "coefficient", "0")}));

  for (const std::string key : {"orbit_normal", "radial_at_start"}) {
    refused("gravity_gradient", key, "[0, 0, 0]", "." + key, {"got a zero vector$", "not all zero"});
  }
  for (const std::string radial : {"[0, 0, 1]", "[1, 0, 1]", "[1, 0, 1e-6]"}) {
    refused("gravity_gradient", "radial_at_start", radial, ".radial_at_start",
            {"must be perpendicular", "expected a direction in the plane of the orbit"});
  }
  for (const std::string bad : {"inertial", "World", "1", "[body]"}) {
    refused("constant_torque", "frame", bad, ".frame", {"expected one of body, world, got"});
  }
}

// Each is finite, and what they make is not: doubles do not hold it.
TEST(Effects, SumsBeyondDoublesAreRefused) {
  expectKeyRefused("effects: [{type: gravity_torque, mass: 1e200, gravity: [0, 0, -1e200], centre_of_mass: [0, 0, 1]}]",
                   ".effects[0]", {"finite", "expected an effect that can act beside those before it"});
}

TEST(Effects, BadSchedulesAreRefused) {
  const auto refused = [](const std::string& segments, const std::string& place,
                          const std::vector<std::string>& pieces) {
    expectKeyRefused("effects: [{type: torque_schedule, segments: " + segments + "}]", ".effects[0].segments" + place,
                     pieces);
  };
  const std::string rest = ", frame: body, torque: [0, 0, 1]}";
  refused("[]", "", {"got an empty list$", "expected a list of at least one segment"});
  refused("{from: 1, to: 2" + rest, "", {"got a map$", "expected a list of at least one segment"});
  refused("[3]", "[0]", {"got 3$"});
  refused("[{from: 2, to: 1" + rest + "]", "[0].to", {"expected a time after from, 2 s, got 1 s$"});
  refused("[{from: 2, to: 2" + rest + "]", "[0].to", {"expected a time after from, 2 s, got 2 s$"});
  for (const std::string other : {"{from: 1, to: 3", "{from: -1, to: 0.5", "{from: 0.5, to: 1", "{from: -1, to: 5"}) {
    refused("[{from: 0, to: 2" + rest + ", " + other + rest + "]", "[1].from",
            {" s that overlaps another, from 0 to 2 s$",
             "expected segments that do not overlap (torques at the same time go"});
  }
  refused("[{from: 1, frame: body, torque: [0, 0, 1]}]", "[0]", {"expected the key to, "});
  // In any order; one may begin where another ends.
  const auto any =
      only<TorqueSchedule>(readBody({"effects: [{type: torque_schedule, segments: [{from: 5, to: 6" + rest +
                                     ", {from: 4, to: 5" + rest + ", {from: -2, to: 1" + rest + "]}]"}));
  EXPECT_EQ(any.segments.size(), 3u);
  // Torques at the same time are two schedules.
  const std::string one = "{type: torque_schedule, segments: [{from: 0, to: 2" + rest + "]}";
  EXPECT_EQ(readBody({"effects: [" + one + ", " + one + "]"}).effects.size(), 2u);
}

TEST(Effects, OneOrbitOneSlug) {
  for (const std::string type : {"gravity_gradient", "internal_dissipation"}) {
    const std::string text = effect(type, types().at(type));
    const std::string map = text.substr(10, text.size() - 11);
    expectKeyRefused("effects: [" + map + ", " + map + "]", ".effects[1]",
                     {"expected one " + type + " per body, got a second$"});
  }
}

TEST(Effects, SeveralWeightsAddUpButAShapeHasOne) {
  const std::string weight = "{type: gravity_torque, mass: 1, centre_of_mass: [0, 0, 0.1]}";
  EXPECT_EQ(readBody({"effects: [" + weight + ", " + weight + "]"}).effects.size(), 2u);
  const std::string shape =
      "bodies: [{name: brick, shape: {type: box, size: [1, 2, 3], mass: 1}, angular_velocity: [0, 0, 1], ";
  EXPECT_NO_THROW(poinsot::scene::readTree(YAML::Load(shape + "effects: [" + weight + "]}]"), "spin.yaml"));
  try {
    poinsot::scene::readTree(YAML::Load(shape + "effects: [" + weight + ", " + weight + "]}]"), "spin.yaml");
    FAIL() << "not refused";
  } catch (const poinsot::scene::Error& error) {
    EXPECT_NE(std::string(error.what()).find("a second gravity_torque"), std::string::npos) << error.what();
  }
}

TEST(Effects, ATranslationDoesNotGoWithAPivot) {
  const std::string weight = "{type: gravity_torque, mass: 1, centre_of_mass: [0, 0, 1]}",
                    moves = "{type: translation}";
  for (const std::string& both : {weight + ", " + moves, moves + ", " + weight}) {
    expectKeyRefused("effects: [" + both + "]", ".effects[1]",
                     {"gravity_torque holds the body at a fixed pivot", "expected one of gravity_torque, translation"});
  }
}

// --- a method for them -----------------------------------------------------------------------------------------------

const std::string kTop = "effects: [{type: gravity_torque, mass: 1, centre_of_mass: [0, 0, 0.1]}]";
const std::string kDamped = "effects: [{type: viscous_damping, coefficient: 0.1}]";

void expectMethodRefused(const std::vector<std::string>& lines, int line, const std::string& place,
                         const std::vector<std::string>& pieces) {
  scene_text::expectRefused(scene_text::body(lines), line, "bodies[0] \"brick\"" + place, pieces);
}

TEST(EffectMethods, TheClosedFormSaysWhyNot) {
  expectMethodRefused({"method: closed_form", kTop}, 3, ".method",
                      {"got \"closed_form\": it is the motion of a free body, and gravity_torque changes that motion",
                       "expected one of taylor8, taylor12, taylor16, taylor20, taylor24, aba84, buss2, rk4, stepper"});
  // A translation leaves the rotation free.
  EXPECT_EQ(readBody({"method: closed_form", "effects: [{type: translation}]"}).method, "closed_form");
}

TEST(EffectMethods, ThoseForFreeBodiesAreRefused) {
  for (const Method& method : freeMethods()) {
    if (method.make_torqued) continue;
    expectMethodRefused({"method: " + std::string(method.name), "step: 0.001", kTop}, 3, ".method",
                        {"got \"" + std::string(method.name) + "\": it is for free bodies and takes no gravity_torque",
                         "expected one of taylor8, "});
  }
}

TEST(EffectMethods, ThoseForTorquesAreRefusedWithoutThem) {
  for (const Method& method : torquedMethods()) {
    if (method.make_free) continue;
    expectMethodRefused(
        {"method: " + std::string(method.name), "step: 0.001"}, 3, ".method",
        {"got \"" + std::string(method.name) + "\": it is for bodies with effects, and nothing acts on this one",
         "expected one of closed_form, lie_euler"});
  }
  expectMethodRefused({"method: taylor9", "step: 0.001", kTop}, 3, ".method",
                      {"got \"taylor9\" (did you mean \"taylor8\"?)$"});
}

TEST(EffectMethods, EveryOneOfTheTableIsAllowed) {
  for (const Method& method : torquedMethods()) {
    const auto top = readBody({"method: " + std::string(method.name), "step: 0.0078125", kTop});
    EXPECT_EQ(top.method, method.name);
    EXPECT_EQ(top.step.value(), 0.0078125);
    EXPECT_FALSE(top.accuracy);
  }
}

TEST(EffectMethods, Aba84TakesNoDamping) {
  for (const std::string& damped :
       {kDamped, std::string("effects: [{type: internal_dissipation, slug_inertia: 1, damping: 1}]")}) {
    for (const std::string how : {"step: 0.001", "accuracy: 1e-6"}) {
      const bool wish = how[0] == 'a';
      std::vector<std::string> lines = {"method: aba84", how, damped};
      if (wish) lines.insert(lines.begin() + 2, "horizon: 3");
      expectMethodRefused(lines, 3, ".method",
                          {"aba84 takes torques that depend on time and attitude alone",
                           "expected one of taylor8, taylor12, taylor16, taylor20, taylor24, buss2, rk4"});
    }
  }
}

TEST(EffectMethods, AStepAlwaysStandsBesideAMethod) {
  expectMethodRefused(
      {"method: taylor8", kTop}, 3, ".method",
      {"got none: taylor8 goes in steps", "expected the key step beside it, a positive finite number (s), got"});
  expectMethodRefused({"step: 0.01", kTop}, 3, ".step",
                      {"got a step without a method$", "one beside a method (taylor8, "});
  expectMethodRefused({"method: taylor8", "step: 0.01", "accuracy: 1e-6", "horizon: 3", kTop}, 4, ".step",
                      {"expected one of the keys accuracy, step, got both"});
}

TEST(EffectMethods, AHopelessStepIsRefusedAndAShorterOneNamed) {
  expectMethodRefused({"method: rk4", "step: 100", kTop}, 4, ".step",
                      {"rk4 with a step of 100 s", "expected a step of at most ", "no method and no step"});
  expectMethodRefused({"method: buss2", "step: 1e12", kTop}, 4, ".step",
                      {"buss2 with a step of 1000000000000 s", "expected a step of at most "});
  // Cut as needed.
  EXPECT_EQ(readBody({"method: taylor16", "step: 100", kTop}).step.value(), 100);
}

TEST(EffectMethods, WithoutMethodAndAccuracyTheChoiceIsAsGoodAsCanBe) {
  for (const std::string& effects : {kTop, kDamped}) {
    const auto body = readBody({effects});
    ASSERT_TRUE(body.accuracy);
    EXPECT_TRUE(body.accuracy->by_default);
    EXPECT_EQ(body.accuracy->error, 1e-9);
    EXPECT_EQ(body.accuracy->horizon, 60);
    EXPECT_FALSE(body.step);
    for (const std::string& name : body.accuracy->candidates) EXPECT_NE(findMethod(name), nullptr) << name;
    const auto& names = body.accuracy->candidates;
    EXPECT_EQ(std::count(names.begin(), names.end(), "aba84"), effects == kTop ? 1 : 0);
  }
  // A program's horizon is the default's.
  scene::ReadOptions options;
  options.horizon = 7;
  const auto scene = scene::readTree(YAML::Load(scene_text::body({kTop})), "tree", options);
  EXPECT_EQ(scene.bodies.at(0).accuracy->horizon, 7);
}

TEST(EffectMethods, AnAccuracyLeavesTheChoiceOfThoseThatTakeTheTorques) {
  for (const std::string method : {"", "method: stepper"}) {
    std::vector<std::string> lines = {"accuracy: 1e-7", "horizon: 12", kDamped};
    if (!method.empty()) lines.push_back(method);
    const auto body = readBody(lines);
    ASSERT_TRUE(body.accuracy);
    EXPECT_FALSE(body.accuracy->by_default);
    EXPECT_EQ(body.accuracy->candidates,
              (std::vector<std::string>{"taylor8", "taylor12", "taylor16", "taylor20", "taylor24", "buss2", "rk4"}));
  }
  const auto named = readBody({"accuracy: 1e-7", "horizon: 12", "method: rk4", kDamped});
  EXPECT_EQ(named.accuracy->candidates, std::vector<std::string>{"rk4"});
  expectMethodRefused({"accuracy: 1e-7", kDamped}, 2, "", {"expected the key horizon, "});
}

// --- a shape on a pivot ----------------------------------------------------------------------------------------------

TEST(Pivot, MomentsOfAShapeAreAboutIt) {
  const auto body = readBody({"shape: {type: box, size: [1, 2, 3], mass: 12}",
                              "effects: [{type: gravity_torque, mass: 12, centre_of_mass: [0.5, 0, -2]}]"});
  // About the centre of mass 13, 10, 5; Steiner: m(c² − cᵢcⱼ).
  Eigen::Matrix3d expected;
  expected << 13 + 12 * 4, 0, 12 * 0.5 * 2, 0, 10 + 12 * 4.25, 0, 12 * 0.5 * 2, 0, 5 + 12 * 0.25;
  const Eigen::Matrix3d axes = body.inertia.axes().toRotationMatrix();
  const Eigen::Matrix3d tensor = axes * body.inertia.moments().asDiagonal() * axes.transpose();
  EXPECT_LE((tensor - expected).norm(), 1e-13) << tensor;
  EXPECT_EQ(body.shape_position, Eigen::Vector3d(0.5, 0, -2));
  // Without a weight, and with moments given as such, nothing is moved.
  EXPECT_EQ(readBody({"shape: {type: box, size: [1, 2, 3], mass: 12}"}).inertia.moments(), Eigen::Vector3d(13, 10, 5));
  EXPECT_EQ(readBody({kTop}).inertia.moments(), Eigen::Vector3d(1, 2, 3));
}

TEST(Pivot, AnotherMassThanTheShapesIsRefused) {
  scene_text::expectRefused(
      scene_text::body({"shape: {type: box, size: [1, 2, 3], mass: 12}",
                        "effects: [{type: gravity_torque, mass: 12.1, centre_of_mass: [0.5, 0, -2]}]"}),
      4, "bodies[0] \"brick\".effects", {"expected the same mass in gravity_torque and shape, got 12.1 kg and 12 kg$"});
}

TEST(Pivot, BeyondWhatDoublesHoldIsRefused) {
  scene_text::expectRefused(
      scene_text::body({"shape: {type: box, size: [1, 2, 3], mass: 12}",
                        "effects: [{type: gravity_torque, mass: 12, centre_of_mass: [1e160, 0, 0]}]"}),
      4, "bodies[0] \"brick\".effects",
      {"expected a centre_of_mass so near the pivot of gravity_torque", "got [1e+160, 0, 0] m: "});
}
