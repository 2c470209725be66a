// How a scene says that it is to be shown: pictures, colours, drawings, rounds, and a body that stands upright.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "scene_text.h"

namespace {

using namespace scene_text;
using poinsot::scene::Body;
using poinsot::scene::Pictures;
using poinsot::scene::Scene;

const std::string kBodies = "bodies:\n  - {name: a, inertia: [1, 2, 3], angular_velocity: [0, 1, 0]}\n";

Eigen::Vector3d momentumOf(const Body& body) {
  const Eigen::Matrix3d tensor = body.inertia.tensor();
  return body.attitude * (tensor * body.omega_body);
}

TEST(Look, picturesAreOneOfFiveWords) {
  EXPECT_EQ(readBody({}).pictures, Pictures::as_it_suits);
  EXPECT_EQ(readBody({"pictures: world"}).pictures, Pictures::world);
  EXPECT_EQ(readBody({"pictures: apart"}).pictures, Pictures::apart);
  EXPECT_EQ(readBody({"pictures: none"}).pictures, Pictures::none);
  expectKeyRefused("pictures: all", ".pictures", {"expected one of both, world, body, apart, none, got \"all\""});
}

TEST(Look, coloursAreSharesOfRedGreenAndBlue) {
  EXPECT_EQ(*readBody({"colour: [0, 0.5, 1]"}).colour, Eigen::Vector3d(0, 0.5, 1));
  EXPECT_FALSE(readBody({}).colour);
  expectKeyRefused("colour: [0, 0, 2]", ".colour", {"from 0 to 1", "got [0, 0, 2]$"});
  expectKeyRefused("colour: [0, 0, -1]", ".colour[2]", {"not negative"});
  expectKeyRefused("colour: [0, 0]", ".colour", {"a list of 3"});
}

TEST(Look, aBodyThatStandsUprightHasLUpwards) {
  for (const char* attitude : {"attitude: [1, 0, 0, 0]", "attitude: [0.3, -0.8, 0.1, 0.5]", "attitude: [0, 0, 1, 0]"}) {
    const Body lying = readBody({attitude}), standing = readBody({attitude, "stand: L_up"});
    const Eigen::Vector3d momentum = momentumOf(standing);
    EXPECT_NEAR(momentum.normalized().z(), 1, 1e-15) << attitude;
    EXPECT_NEAR(momentum.norm(), momentumOf(lying).norm(), 1e-14 * momentum.norm());
    const Eigen::Vector3d omega = standing.attitude * standing.omega_body;
    EXPECT_NEAR(omega.y(), 0, 1e-14 * omega.norm()) << "the part of omega across L is towards the viewer";
    EXPECT_GE(omega.x(), 0);
    EXPECT_EQ(standing.omega_body, lying.omega_body);
  }
}

TEST(Look, onlyAFreeBodyThatSpinsStandsUpright) {
  expectKeyRefused("stand: up", ".stand", {"L_up"});
  expectRefused(body({"stand: L_up", "effects: [{type: viscous_damping, coefficient: 1}]"}), kFirstLine,
                "bodies[0] \"brick\".stand", {"a body that no effect turns", "viscous_damping"});
  expectRefused("bodies: [{name: a, inertia: [1, 2, 3], angular_velocity: [0, 0, 0], stand: L_up}]\n", 1,
                "bodies[0] \"a\".stand", {"a body that spins", "one at rest"});
}

TEST(Look, aSceneMayPlayInRounds) {
  EXPECT_EQ(*read("loop: 15.1\n" + kBodies).loop, 15.1);
  EXPECT_FALSE(read(kBodies).loop);
  expectRefused("loop: 0\n" + kBodies, 1, "loop", {"a positive finite number (s)"});
  expectRefused("loop: 0.01\n" + kBodies, 1, "loop", {"expected at least 0.1 s, got 0.01 s$"});
}

TEST(Look, drawingsAreLinesAndWords) {
  const Scene scene = read(kBodies +
                           "drawings:\n  - {type: line, points: [[0, 0, 0], [1, 2, 3]], colour: [1, 0, 0]}\n"
                           "  - {type: text, text: the border, position: [0, 1, 2]}\n");
  ASSERT_EQ(scene.drawings.size(), 2u);
  EXPECT_EQ(scene.drawings[0].points, (std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 2, 3}}));
  EXPECT_EQ(*scene.drawings[0].colour, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(scene.drawings[1].words, "the border");
  const auto refused = [](const std::string& drawing, const std::string& place, const std::vector<std::string>& what) {
    expectRefused(kBodies + "drawings: [" + drawing + "]\n", 3, "drawings[0]" + place, what);
  };
  refused("{type: line, points: [[0, 0, 0]]}", ".points", {"at least two points"});
  refused("{type: text, position: [0, 0, 0]}", "", {"the key text"});
  refused("{type: text, text: " + std::string(81, 'a') + ", position: [0, 0, 0]}", ".text", {"at most 80"});
  refused("{type: arrow}", ".type", {"line, text"});
  refused("{type: text, text: a, position: [0, 0, 0], points: []}", ".points", {"one of the keys"});
}

}  // namespace
