#include <filesystem>

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
  EXPECT_EQ(messageOf("/nowhere/spin.yaml")
                .rfind("/nowhere/spin.yaml: expected a regular file of at most 4194304 bytes, got none that can be "
                       "read: No such file",
                       0),
            0u)
      << messageOf("/nowhere/spin.yaml");
  const std::string relative = messageOf("nowhere/spin.yaml");
  const std::string place = "No such file or directory: the relative path means " +
                            std::filesystem::current_path().string() + "/nowhere/spin.yaml";
  EXPECT_EQ(relative.rfind("nowhere/spin.yaml: expected a regular file", 0), 0u) << relative;
  EXPECT_NE(relative.find(place), std::string::npos) << relative;
  EXPECT_EQ(messageOf("/tmp"), "/tmp: expected a regular file of at most 4194304 bytes, got a directory");
}

TEST(File, WithoutAScene) {
  expectRefused("", 0, "", {"got an empty file$", "expected a map with the keys rate, bodies"});
  expectRefused("# only this\n", 0, "", {"got an empty file$", "expected a map with the keys rate, bodies"});
  expectRefused("--- ~\n", 1, "", {"got null$", "expected a map with the keys rate, bodies"});
  expectRefused("- a\n- b\n", 1, "", {"got a list of 2$", "expected a map with the keys rate, bodies"});
  expectRefused("spin\n", 1, "", {"got \"spin\"$", "expected a map with the keys rate, bodies"});
}

TEST(File, OfSeveralDocuments) {
  expectRefused("bodies: [" + kBody + "]\n---\nbodies: []\n", 2, "", {"expected one YAML document, got a second$"});
  EXPECT_NO_THROW(read("%YAML 1.2\n---\nbodies: [" + kBody + "]\n...\n"));
}

TEST(File, ThatIsNotYaml) {
  expectRefused("rate: 60\nbodies: []\n]\n", 3, "", {"expected one YAML document, got text that is not YAML: "});
  expectRefused("rate: 60\nbodies: *nobody\n", 2, "", {"expected one YAML document, got text that is not YAML: "});
  expectRefused("rate: 60\nbodies: {\"a\n", 3, "", {"expected one YAML document, got text that is not YAML: "});
}

TEST(File, ControlCharactersAreRefused) {
  expectRefused("rate: 60\n\x04 bodies: []\n", 2, "", {"expected YAML text in UTF-8, got a control character$"});
  expectRefused(std::string("rate: 60\0\n", 10), 1, "", {"expected YAML text in UTF-8, got a control character$"});
}

TEST(File, TagsAreRefused) {
  expectRefused("bodies: !!omap []\n", 1, "bodies", {"the tag", "omap", "expected no tags"});
  expectRefused("!scene\nbodies: []\n", 1, "", {"the tag !scene"});
}

TEST(File, LineEndingsCommentsAndAnchorsAreFine) {
  EXPECT_NO_THROW(read("# a scene\r\nrate: 60\r\nbodies:\r\n  - " + kBody + "\r\n"));
  const auto scene = read(
      "bodies:\n"
      "  - {name: a, inertia: &m [1, 2, 3], angular_velocity: &w [0, 1, 0]}\n"
      "  - {name: b, inertia: *m, angular_velocity: *w}\n");
  EXPECT_EQ(scene.bodies.at(1).inertia.moments(), Eigen::Vector3d(1, 2, 3));
  expectRefused("bodies: &b [*b]\n", 1, "bodies[0]", {"got a list of 1$"});
}

TEST(File, TheLineIsThatOfTheValue) {
  expectRefused(
      "rate: 60\n\nbodies:\n  # one\n  - name: a\n    angular_velocity: [0, 1, 0]\n    inertia:\n      - 1\n      - 2\n"
      "      - -3\n",
      10, "bodies[0] \"a\".inertia[2]", {"got -3$"});
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
