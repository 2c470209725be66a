#include "scene_text.h"

using poinsot::scene::Error;
using poinsot::scene::readFile;
using scene_text::expectRefused;
using scene_text::read;

namespace {

const std::string kBody = "{name: a, inertia: [1, 2, 3], angular_velocity: [0, 1, 0]}";

/** Which axis of the body it mostly spins about, and the rank of the moment about that axis: 0 smallest … 2 largest. */
int rankOfSpin(const poinsot::scene::Body& body) {
  Eigen::Index axis;
  body.omega_body.cwiseAbs().maxCoeff(&axis);
  const Eigen::Matrix3d tensor = body.inertia.tensor();
  EXPECT_TRUE(tensor.isDiagonal(1e-12));
  int rank = 0;
  for (int i = 0; i < 3; ++i) rank += tensor(i, i) < tensor(axis, axis);
  return rank;
}

std::string messageOf(const std::string& path) {
  try {
    readFile(path);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST(File, ThatCannotBeRead) {
  EXPECT_EQ(messageOf("/nowhere/spin.yaml").rfind("/nowhere/spin.yaml: cannot be read, No such file", 0), 0u)
      << messageOf("/nowhere/spin.yaml");
  EXPECT_EQ(messageOf("/tmp").rfind("/tmp: is a directory; expected a regular file", 0), 0u) << messageOf("/tmp");
}

TEST(File, WithoutAScene) {
  expectRefused("", 0, "", {"the file is empty", "allowed: a map with the keys rate, bodies"});
  expectRefused("# only this\n", 0, "", {"the file is empty", "allowed: a map with the keys rate, bodies"});
  expectRefused("--- ~\n", 1, "", {"null is not a map", "allowed: a map with the keys rate, bodies"});
  expectRefused("- a\n- b\n", 1, "", {"a list of 2 is not a map", "allowed: a map with the keys rate, bodies"});
  expectRefused("spin\n", 1, "", {"spin is not a map", "allowed: a map with the keys rate, bodies"});
}

TEST(File, OfSeveralDocuments) {
  expectRefused("bodies: [" + kBody + "]\n---\nbodies: []\n", 2, "",
                {"a second YAML document", "allowed: one YAML document"});
  EXPECT_NO_THROW(read("%YAML 1.2\n---\nbodies: [" + kBody + "]\n...\n"));
}

TEST(File, ThatIsNotYaml) {
  expectRefused("rate: 60\nbodies: []\n]\n", 3, "", {"not YAML", "allowed: one YAML document"});
  expectRefused("rate: 60\nbodies: *nobody\n", 2, "", {"not YAML", "allowed: one YAML document"});
  expectRefused("rate: 60\nbodies: {\"a\n", 3, "", {"not YAML", "allowed: one YAML document"});
}

TEST(File, ControlCharactersAreRefused) {
  expectRefused("rate: 60\n\x04 bodies: []\n", 2, "", {"control character"});
  expectRefused(std::string("rate: 60\0\n", 10), 1, "", {"control character"});
}

TEST(File, TagsAreRefused) {
  expectRefused("bodies: !!omap []\n", 1, "bodies", {"the tag", "omap", "allowed: no tags"});
  expectRefused("!scene\nbodies: []\n", 1, "", {"the tag !scene"});
}

TEST(File, LineEndingsCommentsAndAnchorsAreFine) {
  EXPECT_NO_THROW(read("# a scene\r\nrate: 60\r\nbodies:\r\n  - " + kBody + "\r\n"));
  const auto scene = read(
      "bodies:\n"
      "  - {name: a, inertia: &m [1, 2, 3], angular_velocity: &w [0, 1, 0]}\n"
      "  - {name: b, inertia: *m, angular_velocity: *w}\n");
  EXPECT_EQ(scene.bodies.at(1).inertia.moments(), Eigen::Vector3d(1, 2, 3));
  expectRefused("bodies: &b [*b]\n", 1, "bodies[0]", {"a list of 1 is not a map"});
}

TEST(File, TheLineIsThatOfTheValue) {
  expectRefused(
      "rate: 60\n\nbodies:\n  # one\n  - name: a\n    angular_velocity: [0, 1, 0]\n    inertia:\n      - 1\n      - 2\n"
      "      - -3\n",
      10, "bodies[0] \"a\".inertia[2]", {"-3 is not positive"});
}

TEST(ScenesOfThePackage, TheWingnutSpinsAboutItsIntermediateAxis) {
  const auto scene = readFile(SCENES_DIRECTORY "/dzhanibekov.yaml");
  EXPECT_TRUE(scene.warnings.empty());
  bool found = false;
  for (const auto& body : scene.bodies) {
    if (body.name != "wingnut") continue;
    found = true;
    EXPECT_EQ(rankOfSpin(body), 1);
    EXPECT_GT((body.omega_body.array() != 0).count(), 1) << "nothing disturbs it";
  }
  EXPECT_TRUE(found);
}

TEST(ScenesOfThePackage, RegimesHoldOneOfEach) {
  const auto scene = readFile(SCENES_DIRECTORY "/regimes.yaml");
  EXPECT_TRUE(scene.warnings.empty());
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(rankOfSpin(scene.bodies[0]), 0);
  EXPECT_EQ(rankOfSpin(scene.bodies[1]), 1);
  EXPECT_EQ(rankOfSpin(scene.bodies[2]), 2);
}
