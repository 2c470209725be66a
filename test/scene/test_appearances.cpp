#include <fstream>

#include "scene_text.h"

using scene_text::expectKeyRefused;
using scene_text::readBody;

namespace {

const std::string kBook = "mesh: package://poinsot/meshes/book.dae";

}  // namespace

TEST(Appearance, IsOptionalAndChangesNothingElse) {
  EXPECT_FALSE(readBody({}).appearance);
  const auto plain = readBody({"shape: {type: box, size: [3, 2, 1], mass: 1}"});
  const auto drawn =
      readBody({"shape: {type: box, size: [3, 2, 1], mass: 1}", "appearance: {" + kBook + ", scale: 7}"});
  EXPECT_EQ(plain.inertia.tensor(), drawn.inertia.tensor());
  EXPECT_EQ(plain.shape->boundingRadius(), drawn.shape->boundingRadius());
}

TEST(Appearance, LiesAsTheMeshDoesUnlessTheSceneSaysOtherwise) {
  const auto plain = readBody({"appearance: {" + kBook + "}"}).appearance.value();
  EXPECT_EQ(plain.mesh, "package://poinsot/meshes/book.dae");
  for (const char* mesh : {"package://a/b.DAE", "package://a/b.Stl"}) {
    EXPECT_EQ(readBody({std::string("appearance: {mesh: ") + mesh + "}"}).appearance->mesh, mesh);
  }
  EXPECT_EQ(plain.scale, Eigen::Vector3d(1, 1, 1));
  EXPECT_EQ(plain.position, Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(plain.orientation.coeffs(), Eigen::Quaterniond(1, 0, 0, 0).coeffs());

  const auto turned =
      readBody({"appearance: {" + kBook + ", scale: [1, 2, 3e-3], position: [4, 5, -6], orientation: [0, 0, 2, 0]}"})
          .appearance.value();
  EXPECT_EQ(turned.scale, Eigen::Vector3d(1, 2, 3e-3));
  EXPECT_EQ(turned.position, Eigen::Vector3d(4, 5, -6));
  EXPECT_EQ(turned.orientation.coeffs(), Eigen::Quaterniond(0, 0, 1, 0).coeffs());
  EXPECT_EQ(readBody({"appearance: {" + kBook + ", scale: 1e-3}"}).appearance->scale,
            Eigen::Vector3d(1e-3, 1e-3, 1e-3));
}

TEST(Appearance, UnknownAndMissingKeysAreRefused) {
  expectKeyRefused("appearance: {}", ".appearance", {"expected the key mesh, ", "package://<package>/<path>"});
  expectKeyRefused("appearance: package://poinsot/meshes/book.dae", ".appearance",
                   {"expected a mesh", "got \"package://poinsot/meshes/book.dae\"$"});
  expectKeyRefused("appearance: {" + kBook + ", sclae: 2}", ".appearance.sclae",
                   {" (did you mean \"scale\"?)$", "expected one of the keys mesh, scale, position, orientation"});
  expectKeyRefused("apearance: {" + kBook + "}", ".apearance", {" (did you mean \"appearance\"?)$"});
}

TEST(Appearance, NumbersAreCheckedLikeAllOthers) {
  for (const char* scale : {"0", "-1", ".nan", ".inf", "big", "[1, 1, 0]", "[1, 1]", "{x: 1}"}) {
    SCOPED_TRACE(scale);
    const bool list = scale[0] == '[' && std::string(scale).size() > 7;
    expectKeyRefused("appearance: {" + kBook + ", scale: " + scale + "}",
                     std::string(".appearance.scale") + (list ? "[2]" : ""), {"expected "});
  }
  expectKeyRefused("appearance: {" + kBook + ", position: [0, .nan, 0]}", ".appearance.position[1]",
                   {"got .nan$", "(m)"});
  expectKeyRefused("appearance: {" + kBook + ", orientation: [0, 0, 0, 0]}", ".appearance.orientation", {"expected "});
}

TEST(Appearance, MeshesAreNamedByPackageOrFile) {
  const std::string expected = "package://<package>/<path> or file:///<path> of a COLLADA or STL mesh";
  for (const char* mesh : {"book.dae", "/tmp/book.dae", "http://example.com/book.dae", "package://", "package:///a.dae",
                           "package://poinsot.dae", "package://a b/c.dae", "file://book.dae", "''"}) {
    expectKeyRefused(std::string("appearance: {mesh: '") + (mesh == std::string("''") ? "" : mesh) + "'}",
                     ".appearance.mesh",
                     {"got \"" + std::string(mesh == std::string("''") ? "" : mesh) + "\"$", expected});
  }
  expectKeyRefused("appearance: {mesh: package://poinsot/meshes/book.obj}", ".appearance.mesh",
                   {"got \"package://poinsot/meshes/book.obj\"$", expected});
  expectKeyRefused("appearance: {mesh: [a]}", ".appearance.mesh", {"got a list of 1$", expected});
  expectKeyRefused("appearance: {mesh: }", ".appearance.mesh", {"got null$", expected});
}

TEST(Appearance, AFileMustBeThere) {
  const std::string path = testing::TempDir() + "poinsot_mesh_" + std::to_string(getpid()) + ".stl";
  expectKeyRefused("appearance: {mesh: file://" + path + "}", ".appearance.mesh", {"there is no such file"});
  std::ofstream(path) << "solid\nendsolid\n";
  EXPECT_EQ(readBody({"appearance: {mesh: file://" + path + "}"}).appearance->mesh, "file://" + path);
  std::remove(path.c_str());
  expectKeyRefused("appearance: {mesh: file:///tmp/.stl}", ".appearance.mesh", {"there is no such file"});
}
