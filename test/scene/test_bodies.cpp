#include <cmath>

#include "scene_text.h"

using poinsot::scene::Body;
using poinsot::scene::Scene;
using scene_text::body;
using scene_text::expectKeyRefused;
using scene_text::expectRefused;
using scene_text::read;
using scene_text::readBody;

namespace {

std::string named(const std::vector<std::string>& names) {
  std::string text = "bodies:\n";
  for (const std::string& name : names) {
    text += "  - name: " + name + "\n    inertia: [1, 2, 3]\n    angular_velocity: [0, 1, 0]\n";
  }
  return text;
}

double distance(const Eigen::Quaterniond& q, double w, double x, double y, double z) {
  return (q.coeffs() - Eigen::Vector4d(x, y, z, w)).norm();
}

}  // namespace

TEST(Scene, SmallestSceneGetsTheDefaults) {
  const Scene scene = read("bodies:\n  - {name: top, inertia: [1, 2, 3], angular_velocity: [0.5, -1, 2e-3]}\n");
  EXPECT_FALSE(scene.rate);
  EXPECT_TRUE(scene.warnings.empty());
  ASSERT_EQ(scene.bodies.size(), 1u);
  const Body& top = scene.bodies[0];
  EXPECT_EQ(top.name, "top");
  EXPECT_EQ(top.inertia.moments(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(distance(top.inertia.axes(), 1, 0, 0, 0), 0);
  EXPECT_FALSE(top.shape);
  EXPECT_EQ(distance(top.attitude, 1, 0, 0, 0), 0);
  EXPECT_EQ(top.omega_body, Eigen::Vector3d(0.5, -1, 2e-3));
  EXPECT_EQ(top.method, "closed_form");
  EXPECT_FALSE(top.step);
  EXPECT_FALSE(top.translation);
}

TEST(Scene, EveryKeyAtOnce) {
  const Scene scene = read(
      "rate: 50\n"
      "bodies:\n"
      "  - name: one\n"
      "    inertia: [3, 1, 2]\n"
      "    attitude: [0, 0, 2, 0]\n"
      "    angular_velocity: [1, 2, 3]\n"
      "    method: rk4\n"
      "    step: 0.01\n"
      "    effects:\n"
      "      - {type: translation, position: [1, 2, 3], velocity: [4, 5, 6], acceleration: [7, 8, 9]}\n"
      "  - name: two\n"
      "    shape: {type: box, size: [1, 2, 3], mass: 12}\n"
      "    angular_velocity: [0, 0, 0]\n"
      "    effects: []\n");
  EXPECT_EQ(scene.rate.value(), 50);
  ASSERT_EQ(scene.bodies.size(), 2u);
  const Body& one = scene.bodies[0];
  EXPECT_EQ(one.inertia.moments(), Eigen::Vector3d(3, 1, 2));  // the order is kept
  EXPECT_EQ(distance(one.attitude, 0, 0, 1, 0), 0);
  EXPECT_EQ(one.method, "rk4");
  EXPECT_EQ(one.step.value(), 0.01);
  ASSERT_TRUE(one.translation);
  EXPECT_EQ(one.translation->position, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(one.translation->velocity, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(one.translation->acceleration, Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(scene.bodies[1].name, "two");
  EXPECT_TRUE(scene.bodies[1].shape);
  EXPECT_TRUE(scene.bodies[1].omega_body.isZero(0));
  EXPECT_FALSE(scene.bodies[1].translation);
}

TEST(Scene, RateIsPositive) {
  const std::string rest = "\n" + named({"a"});
  const std::string expected = "expected a positive finite number (Hz)";
  EXPECT_EQ(read("rate: 0.5" + rest).rate.value(), 0.5);
  expectRefused("rate: 0" + rest, 1, "rate", {"got 0$", expected});
  expectRefused("rate: -60" + rest, 1, "rate", {"got -60$", expected});
  expectRefused("rate: .inf" + rest, 1, "rate", {"got .inf$", expected});
  expectRefused("rate: fast" + rest, 1, "rate", {"got \"fast\": not a decimal number$", expected});
  expectRefused("rate: [60]" + rest, 1, "rate", {"got a list of 1$", expected});
}

TEST(Scene, ARateIsReadAlikeWhereverItStands) {
  for (const char* text : {"100", "1e2", "+100.0", "1E+2"}) {
    EXPECT_EQ(poinsot::scene::readRate(YAML::Node(std::string(text)), "parameter ~rate"), 100) << text;
  }
  for (const char* text : {"0", "-1", "fast", "0x10", ".inf", ""}) {
    EXPECT_THROW(poinsot::scene::readRate(YAML::Node(std::string(text)), "parameter ~rate"), poinsot::scene::Error)
        << text;
  }
}

TEST(Scene, BodiesThatNoViewerShowsMakeAWarning) {
  const auto warnings = [](const char* position) {
    return read(body({std::string("effects: [{type: translation, position: ") + position + "}]"})).warnings;
  };
  EXPECT_TRUE(warnings("[9e3, 0, 0]").empty());
  ASSERT_EQ(warnings("[0, 4e6, 0]").size(), 1u);
  EXPECT_NE(
      warnings("[0, 4e6, 0]")[0].find("bodies[0] \"brick\": starts 4e+06 m from the origin of frame world, where the "
                                      "floats of RViz lie 0.25 m apart"),
      std::string::npos)
      << warnings("[0, 4e6, 0]")[0];
  EXPECT_NE(warnings("[0, 4e6, 0]")[0].find("brick_space as RViz's fixed frame"), std::string::npos);
}

TEST(Scene, BodiesAreANonEmptyListOfMaps) {
  expectRefused("rate: 60\n", 1, "", {"expected the key bodies, ", "a list of at least one body"});
  expectRefused("bodies: []\n", 1, "bodies", {"got an empty list$", "a list of at least one body"});
  expectRefused("bodies:\n", 1, "bodies", {"got null$", "a list of at least one body"});
  expectRefused("bodies: {name: a}\n", 1, "bodies", {"got a map$", "a list of at least one body"});
  expectRefused("rate: 1\nbodies: [a]\n", 2, "bodies[0]", {"got \"a\"$", "expected a body"});
  expectRefused("bodies:\n  - []\n", 2, "bodies[0]", {"got an empty list$", "expected a body"});
}

TEST(Scene, UnknownKeysAreRefusedWithTheKnownOnes) {
  expectRefused("speed: 1\n" + named({"a"}), 1, "speed",
                {"got \"speed\"$", "expected one of the keys rate, loop, bodies, drawings, got"});
  expectRefused(
      "body: 1\n" + named({"a"}), 1, "body",
      {"got \"body\" (did you mean \"bodies\"?)$", "expected one of the keys rate, loop, bodies, drawings, got"});
  expectRefused(named({"a"}) + "Rate: 60\n", 5, "Rate",
                {" (did you mean \"rate\"?)$", "expected one of the keys rate, loop, bodies, drawings, got"});
  const std::string expected =
      "expected one of the keys name, inertia, shape, appearance, attitude, angular_velocity, method, step, accuracy, "
      "horizon, effects, pictures, stand, colour, got";
  expectKeyRefused("weather: red", ".weather", {"got \"weather\"$", expected});
  expectKeyRefused("atitude: [1, 0, 0, 0]", ".atitude", {" (did you mean \"attitude\"?)$", expected});
  expectKeyRefused("angular_velocty: [1, 0, 0]", ".angular_velocty",
                   {" (did you mean \"angular_velocity\"?)$", expected});
  expectKeyRefused("<<: {step: 1}", ".<<", {"got \"<<\"$", expected});
}

TEST(Scene, OtherWordsForAKeyLeadToIt) {
  const auto expectMeant = [](const std::string& key, const std::string& meant) {
    expectKeyRefused(key + ": 1", "." + key, {"got \"" + key + "\" (did you mean \"" + meant + "\"", "?)$"});
  };
  expectKeyRefused("omega: [1, 0, 0]", ".omega", {"got \"omega\" (did you mean \"angular_velocity\"?)$"});
  expectKeyRefused("mass: 1", ".mass", {"(did you mean \"shape\", which takes a type with its sizes and mass?)$"});
  expectKeyRefused("position: [1, 0, 0]", ".position",
                   {"(did you mean \"effects\", which take type: translation with a position?)$"});
  for (const char* key : {"Omega", "w", "spin", "angular_rate"}) expectMeant(key, "angular_velocity");
  for (const char* key : {"size", "dimensions", "geometry", "box"}) expectMeant(key, "shape");
  for (const char* key : {"moments", "tensor", "moment_of_inertia"}) expectMeant(key, "inertia");
  for (const char* key : {"orientation", "quaternion"}) expectMeant(key, "attitude");
  for (const char* key : {"dt", "time_step"}) expectMeant(key, "step");
  for (const char* key : {"integrator", "solver"}) expectMeant(key, "method");
  for (const char* key : {"velocity", "torque", "gravity", "damping"}) expectMeant(key, "effects");
  expectMeant("tolerance", "accuracy");
  expectMeant("duration", "horizon");
  expectMeant("mesh", "appearance");
  // Each place has its own meaning of a word.
  expectKeyRefused("shape: {type: box, dimensions: [1, 1, 1], mass: 1}", ".shape.dimensions",
                   {"(did you mean \"size\"?)$"});
  expectRefused("frequency: 60\n" + named({"a"}), 1, "frequency", {"(did you mean \"rate\"?)$"});
}

TEST(Scene, SuggestionsEndAtTwoEdits) {
  expectKeyRefused("stepp: 1", ".stepp", {" (did you mean \"step\"?)$"});
  expectKeyRefused("stoop: 1", ".stoop", {" (did you mean \"step\"?)$"});
  expectKeyRefused("stooop: 1", ".stooop", {"got \"stooop\"$"});
  expectKeyRefused("z: 1", ".z", {"got \"z\"$"});
}

TEST(Scene, DuplicateKeysAreRefused) {
  expectRefused("rate: 1\nrate: 1\n" + named({"a"}), 2, "rate", {"got a duplicate key$", "every key once"});
  expectRefused(body({"step: 1", "step: 1"}), 4, "bodies[0] \"brick\".step", {"got a duplicate key$"});
  expectRefused(body({"name: brick"}), 3, "bodies[0] \"brick\".name", {"got a duplicate key$"});
  expectKeyRefused("shape: {type: box, mass: 1, mass: 2}", ".shape.mass", {"got a duplicate key$"});
  expectKeyRefused("effects: [{type: translation, type: translation}]", ".effects[0].type", {"got a duplicate key$"});
}

TEST(Scene, KeysAreWords) {
  expectRefused("? [a]\n: 1\n" + named({"a"}), 1, "", {"expected words as keys", "got a list of 1$"});
  expectRefused(body({"[a, b]: 1"}), 2, "bodies[0] \"brick\"", {"expected words as keys", "got a list of 2$"});
}

TEST(Name, ValidOnes) {
  for (const char* name : {"a", "Brick", "t_handle", "x1", "yes_man", "nullable", "'quoted'", "inf", "nan"}) {
    SCOPED_TRACE(name);
    EXPECT_NO_THROW(read(named({name})));
  }
  EXPECT_EQ(read(named({"'quoted'"})).bodies[0].name, "quoted");
}

TEST(Name, InvalidOnesAreShown) {
  for (const char* name : {"1a", "_a", "a/b", "/a", "a-b", "a.b", "\"a b\"", "é", "~a", "5", "''"}) {
    SCOPED_TRACE(name);
    std::string bare = name;
    if (bare.front() == '"' || bare.front() == '\'') bare = bare.substr(1, bare.size() - 2);
    const std::string got = bare == "1a" || bare == "5" ? bare : "\"" + bare + "\"";
    expectRefused(named({name}), 2, "bodies[0] \"" + bare + "\".name",
                  {"expected a letter, then letters, digits and underscores, got " + got + "$"});
  }
  expectRefused(named({""}), 2, "bodies[0].name", {"got null$", "a letter, then"});
  expectRefused(named({"null"}), 2, "bodies[0].name", {"got null$", "a letter, then"});
  expectRefused(named({"[a]"}), 2, "bodies[0].name", {"got a list of 1$", "a letter, then"});
  expectRefused(named({"{a: b}"}), 2, "bodies[0].name", {"got a map$", "a letter, then"});
  expectRefused("bodies:\n  - {inertia: [1, 2, 3], angular_velocity: [0, 1, 0]}\n", 2, "bodies[0]",
                {"expected the key name, ", "a letter, then"});
}

TEST(Name, BooleansOfYamlAreRefused) {
  for (const char* word : {"yes", "No", "ON", "off", "true", "False", "TRUE", "y", "N"}) {
    SCOPED_TRACE(word);
    for (const char* quote : {"", "'"}) {
      expectRefused(named({quote + std::string(word) + quote}), 2, "bodies[0] \"" + std::string(word) + "\".name",
                    {"got \"" + std::string(word) + "\": ", "boolean or null"});
    }
  }
  expectRefused(named({"'null'"}), 2, "bodies[0] \"null\".name", {"got \"null\": ", "boolean or null"});
}

TEST(Name, DuplicatesAreRefused) {
  expectRefused(named({"a", "b", "a"}), 8, "bodies[2] \"a\".name",
                {"expected a name that no other body has", "got \"a\" a second time$"});
  EXPECT_EQ(read(named({"a", "A"})).bodies.size(), 2u);
}

TEST(Name, FramesDoNotClash) {
  expectRefused(named({"world"}), 2, "bodies[0] \"world\".name", {"the frame world", "the fixed frame"});
  for (const char* suffix : {"_space", "_model", "_space_body"}) {
    SCOPED_TRACE(suffix);
    const std::string other = "top" + std::string(suffix);
    expectRefused(named({"top", other}), 5, "bodies[1] \"" + other + "\".name",
                  {"the frame " + other + " of the body " + other, "a frame of the body top", "<name>_space_body"});
    expectRefused(named({other, "top"}), 5, "bodies[1] \"top\".name",
                  {"the frame " + other + " of the body top", "a frame of the body " + other});
  }
  EXPECT_EQ(read(named({"top", "top_body", "top_spaces", "space", "world_a"})).bodies.size(), 5u);
}

TEST(Inertia, TensorHasItsPrincipalAxesFound) {
  // diag(1, 2, 4) turned about z by 30°.
  const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
  Eigen::Matrix3d turn;
  turn << c, -s, 0, s, c, 0, 0, 0, 1;
  const Eigen::Matrix3d tensor = turn * Eigen::Vector3d(1, 2, 2.5).asDiagonal() * turn.transpose();
  char line[300];
  std::snprintf(line, sizeof line, "inertia: [[%.17g, %.17g, 0], [%.17g, %.17g, 0], [0, 0, 2.5]]", tensor(0, 0),
                tensor(0, 1), tensor(1, 0), tensor(1, 1));
  const Body b = readBody({line});
  EXPECT_LT((b.inertia.moments() - Eigen::Vector3d(1, 2, 2.5)).norm(), 1e-14);
  EXPECT_LT((b.inertia.tensor() - tensor).norm(), 1e-14);
  EXPECT_EQ(readBody({"inertia: [[3, 0, 0], [0, 1, 0], [0, 0, 2.5]]"}).inertia.moments(), Eigen::Vector3d(3, 1, 2.5));
}

TEST(Inertia, BadMomentsAreRefused) {
  const std::string expected = "expected a positive finite number (kg·m²)";
  expectKeyRefused("inertia: [1, 2, -3]", ".inertia[2]", {"got -3$", expected});
  expectKeyRefused("inertia: [0, 2, 3]", ".inertia[0]", {"got 0$", expected});
  expectKeyRefused("inertia: [1, -0.0, 3]", ".inertia[1]", {"got -0.0$", expected});
  expectKeyRefused("inertia: [1, .nan, 3]", ".inertia[1]", {"got .nan$", expected});
  expectKeyRefused("inertia: [1, .inf, 3]", ".inertia[1]", {"got .inf$", expected});
  expectKeyRefused("inertia: [1, 1e999, 3]", ".inertia[1]", {"got 1e999: not finite in double precision$", expected});
  expectKeyRefused("inertia: [1, 1e-400, 3]", ".inertia[1]", {"got 1e-400: zero in double precision$", expected});
  expectKeyRefused("inertia: [1, heavy, 3]", ".inertia[1]", {"got \"heavy\": not a decimal number$", expected});
}

TEST(Inertia, WrongShapesOfListsAreRefused) {
  const std::string expected = "3 positive finite principal moments, or a symmetric positive definite tensor";
  expectKeyRefused("inertia: 1", ".inertia", {"got 1$", expected});
  expectKeyRefused("inertia: {x: 1}", ".inertia", {"got a map$", expected});
  expectKeyRefused("inertia: [1, 2]", ".inertia", {"got a list of 2$", expected});
  expectKeyRefused("inertia: [1, 2, 3, 4]", ".inertia", {"got a list of 4$", expected});
  expectKeyRefused("inertia: [1, 0, 0, 0, 2, 0, 0, 0, 3]", ".inertia", {"got a list of 9$", expected});
  expectKeyRefused("inertia: [[1, 0, 0], [0, 2, 0]]", ".inertia", {"got a list of 2$", expected});
  expectKeyRefused("inertia: [[1, 0, 0], [0, 2], [0, 0, 3]]", ".inertia[1]", {"got a list of 2$", "(kg·m²)"});
  expectKeyRefused("inertia: [1, [0, 2, 0], [0, 0, 3]]", ".inertia[0]", {"got 1$", "a list of 3"});
  expectKeyRefused("inertia: [[1, 0, 0], [0, x, 0], [0, 0, 3]]", ".inertia[1][1]",
                   {"got \"x\": not a decimal number$"});
}

TEST(Inertia, BadTensorsAreRefused) {
  const std::string expected = "expected 3 positive finite principal moments, or a symmetric positive definite tensor";
  expectKeyRefused("inertia: [[2, 0.5, 0], [0.4, 2, 0], [0, 0, 3]]", ".inertia",
                   {"not symmetric", "0.5", "0.4", expected});
  expectKeyRefused("inertia: [[1, 2, 0], [2, 1, 0], [0, 0, 3]]", ".inertia",
                   {"not positive definite", "moments are -", expected});
  expectKeyRefused("inertia: [[1, 1, 0], [1, 1, 0], [0, 0, 2]]", ".inertia", {"not positive definite", expected});
  expectKeyRefused("inertia: [[1, 0, 0], [0, -2, 0], [0, 0, 3]]", ".inertia", {"-2", expected});
  expectKeyRefused("inertia: [[0, 0, 0], [0, 0, 0], [0, 0, 0]]", ".inertia", {"0", expected});
}

TEST(Inertia, MomentsOfNoRealBodyMakeAWarning) {
  const scene_text::TemporaryFile file(body({"inertia: [1, 2, 3.5]"}));
  const Scene scene = poinsot::scene::readFile(file.path());
  EXPECT_EQ(scene.bodies[0].inertia.moments(), Eigen::Vector3d(1, 2, 3.5));
  ASSERT_EQ(scene.warnings.size(), 1u);
  const std::string& warning = scene.warnings[0];
  EXPECT_EQ(warning.rfind(file.path() + ":3: bodies[0] \"brick\".inertia: ", 0), 0u) << warning;
  EXPECT_NE(warning.find("1, 2, 3.5 kg·m²"), std::string::npos) << warning;
  EXPECT_NE(warning.find("no real body"), std::string::npos) << warning;

  EXPECT_EQ(read(body({"inertia: [[1, 0, 0], [0, 5, 1], [0, 1, 1]]"})).warnings.size(), 1u);
  EXPECT_TRUE(read(body({"inertia: [1, 2, 3]"})).warnings.empty());  // a flat body
  EXPECT_TRUE(read(body({"inertia: [0.1, 0.2, 0.3]"})).warnings.empty());
}

TEST(Inertia, ExactlyOneOfInertiaAndShape) {
  const std::string expected = "expected exactly one of the keys inertia, shape";
  expectRefused(body({"inertia: [1, 2, 3]", "shape: {type: box, size: [1, 1, 1], mass: 1}"}), 2, "bodies[0] \"brick\"",
                {"got both$", expected});
  expectRefused("bodies:\n  - {name: a, angular_velocity: [0, 1, 0]}\n", 2, "bodies[0] \"a\"", {"got none$", expected});
}

TEST(Attitude, IsNormalised) {
  EXPECT_LT(distance(readBody({"attitude: [3, 0, 0, 4]"}).attitude, 0.6, 0, 0, 0.8), 1e-15);
  EXPECT_LT(distance(readBody({"attitude: [-1, 1, -1, 1]"}).attitude, -0.5, 0.5, -0.5, 0.5), 1e-15);
  const double h = std::sqrt(0.5);
  EXPECT_LT(distance(readBody({"attitude: [1e308, 1e308, 0, 0]"}).attitude, h, h, 0, 0), 1e-15);
  EXPECT_LT(distance(readBody({"attitude: [1.7e308, 1.7e308, 1.7e308, 1.7e308]"}).attitude, 0.5, 0.5, 0.5, 0.5), 1e-15);
  EXPECT_LT(distance(readBody({"attitude: [0, 1e-200, 0, -1e-200]"}).attitude, 0, h, 0, -h), 1e-15);
  EXPECT_LT(distance(readBody({"attitude: [0, 5e-324, 0, 5e-324]"}).attitude, 0, h, 0, h), 1e-15);
}

TEST(Attitude, BadOnesAreRefused) {
  const std::string expected = "expected a list of 4 finite numbers";
  expectKeyRefused("attitude: [0, 0, 0, 0]", ".attitude", {"got a zero quaternion$", "not all zero"});
  expectKeyRefused("attitude: [0, -0.0, 1e-400, 0]", ".attitude", {"got a zero quaternion$", "not all zero"});
  expectKeyRefused("attitude: [1, 0, 0]", ".attitude", {"got a list of 3$", expected});
  expectKeyRefused("attitude: [1, 0, 0, 0, 0]", ".attitude", {"got a list of 5$", expected});
  expectKeyRefused("attitude: identity", ".attitude", {"got \"identity\"$", expected});
  expectKeyRefused("attitude: [1, 0, .nan, 0]", ".attitude[2]", {"got .nan$", "expected a finite number"});
}

TEST(AngularVelocity, IsRequiredAndGivesAnEnergyThatDoublesHold) {
  expectRefused("bodies:\n  - {name: a, inertia: [1, 2, 3]}\n", 2, "bodies[0] \"a\"",
                {"expected the key angular_velocity, ", "a list of 3 finite numbers (rad/s)"});
  expectKeyRefused("angular_velocity: [0, 1e200, 0]", ".angular_velocity",
                   {"got [0, 1e+200, 0]: ", "energy is not finite"});
  expectRefused(body({"inertia: [1e-300, 1e-300, 1e-300]", "angular_velocity: [0, 1e305, 0]"}), 4,
                "bodies[0] \"brick\".angular_velocity", {"energy", "is not finite"});
  EXPECT_EQ(readBody({"angular_velocity: [0, 1e100, 0]"}).omega_body.y(), 1e100);

  expectKeyRefused("angular_velocity: [0, 1e-200, 0]", ".angular_velocity",
                   {"energy is too small for double precision", "expected 3 finite numbers (rad/s), all zero or"});
  expectRefused(body({"inertia: [1e-200, 1e-200, 1e-200]", "angular_velocity: [0, 1, 0]"}), 4,
                "bodies[0] \"brick\".angular_velocity", {"squared angular momentum is too small"});
  EXPECT_EQ(readBody({"angular_velocity: [0, 1e-150, 0]"}).omega_body.y(), 1e-150);
  EXPECT_EQ(readBody({"angular_velocity: [0, 0, 0]"}).omega_body.y(), 0);
}
