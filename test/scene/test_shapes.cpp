#include <cmath>

#include "scene_text.h"

using scene_text::expectKeyRefused;
using scene_text::readBody;

namespace {

Eigen::Matrix3d tensorOf(const std::string& shape) {
  return readBody({"shape: " + shape}).inertia.tensor();
}

void expectTensor(const std::string& shape, const Eigen::Matrix3d& expected) {
  const Eigen::Matrix3d tensor = tensorOf(shape);
  EXPECT_LT((tensor - expected).norm(), 1e-13 * expected.norm()) << shape << "\n" << tensor << "\n\n" << expected;
}

void expectMoments(const std::string& shape, double x, double y, double z) {
  expectTensor(shape, Eigen::Vector3d(x, y, z).asDiagonal());
}

}  // namespace

TEST(Shape, SolidsHaveTheirTextbookMoments) {
  expectMoments("{type: box, size: [1, 2, 3], mass: 12}", 4 + 9, 9 + 1, 1 + 4);
  expectMoments("{type: ellipsoid, size: [2, 4, 6], mass: 5}", 4 + 9, 9 + 1, 1 + 4);  // semi-axes 1, 2, 3
  expectMoments("{type: cylinder, radius: 2, height: 3, mass: 12}", 12 + 9, 12 + 9, 24);
}

TEST(Shape, LIsTwoBarsByTheParallelAxisTheorem) {
  // Bars 3×1×1 and 1×1×3 of mass 3 each, the long axis of each along x and z, centres (1, 0, 0) and (0, 0, 2).
  const auto brick = readBody({"shape: {type: l_shape, length_x: 3, length_z: 4, thickness: 1, mass: 6}"});
  const double dx = 0.5, dz = 1;  // half the distance of the centres
  const double long_bar = 3 * 10 / 12.0, thin = 3 * 2 / 12.0;
  Eigen::Matrix3d expected;
  expected << thin + long_bar + 6 * dz * dz, 0, 6 * dx * dz,  //
      0, 2 * long_bar + 6 * (dx * dx + dz * dz), 0,           //
      6 * dx * dz, 0, long_bar + thin + 6 * dx * dx;
  EXPECT_LT((brick.inertia.tensor() - expected).norm(), 1e-13 * expected.norm()) << brick.inertia.tensor();
  ASSERT_TRUE(brick.shape);
  EXPECT_EQ(brick.shape->parts().size(), 2u);
  EXPECT_NEAR(brick.shape->mass(), 6, 1e-14);
}

TEST(Shape, THandleIsABarAlongYWithAStemAlongZ) {
  // Volumes 4π and 3π: masses 4 and 3. The stem's centre is 1 + 1.5 above the bar's.
  const double bar = 4, stem = 3, reduced = bar * stem / (bar + stem), h2 = 2.5 * 2.5;
  const double bar_along = bar * 0.5, bar_across = bar * (3 + 16) / 12;
  const double stem_along = stem * 0.5, stem_across = stem * (3 + 9) / 12;
  expectMoments("{type: t_handle, bar_radius: 1, bar_length: 4, stem_radius: 1, stem_length: 3, mass: 7}",
                bar_across + stem_across + reduced * h2, bar_along + stem_across + reduced * h2,
                bar_across + stem_along);
}

TEST(Shape, TwoCylindersStandAcross) {
  const double first = 2, second = 4, reduced = first * second / (first + second);
  const Eigen::Vector3d d(0.5, -1, 2);
  const Eigen::Vector3d own1(first * (3 + 4) / 12, first * (3 + 4) / 12, first * 0.5);
  const Eigen::Vector3d own2(second * 0.5, second * (3 + 16) / 12, second * (3 + 16) / 12);
  Eigen::Matrix3d expected = (own1 + own2).asDiagonal();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) expected(i, j) += reduced * ((i == j ? d.dot(d) : 0) - d[i] * d[j]);
  }
  expectTensor(
      "{type: two_cylinders, radius: 1, height: 2, second_radius: 1, second_height: 4, offset: [0.5, -1, 2], "
      "mass: 6}",
      expected);
}

TEST(Shape, WingnutIsSymmetricWithThreeParts) {
  const auto brick =
      readBody({"shape: {type: wingnut, hub_radius: 0.2, hub_height: 0.5, wing_size: [0.8, 0.1, 0.4], "
                "dihedral: 0.4, mass: 2}"});
  ASSERT_TRUE(brick.shape);
  ASSERT_EQ(brick.shape->parts().size(), 3u);
  EXPECT_NEAR(brick.shape->mass(), 2, 1e-14);
  EXPECT_LT(brick.shape->parts()[0].centre.z(), 0);  // the wings rise
  EXPECT_NEAR(brick.inertia.tensor()(0, 2), 0, 1e-15);
  EXPECT_NO_THROW(
      tensorOf("{type: wingnut, hub_radius: 1, hub_height: 1, wing_size: [1, 1, 1], dihedral: -1.57, mass: 1}"));
  expectKeyRefused(
      "shape: {type: wingnut, hub_radius: 1, hub_height: 1, wing_size: [1, 1, 1], dihedral: 1.58, mass: 1}",
      ".shape.dihedral", {"got 1.58$", "expected a number from -π/2 to π/2 (rad)"});
}

TEST(Shape, AssemblyPlacesItsParts) {
  // Two unit cubes of mass 6, 4 apart along y; the second one's turn by 90° shows nothing.
  expectMoments(
      "{type: assembly, parts: [{type: box, size: [1, 1, 1], mass: 6}, "
      "{type: box, size: [1, 1, 1], mass: 6, position: [0, 4, 0], orientation: [3, 3, 0, 0]}]}",
      2 + 12 * 4, 2, 2 + 12 * 4);
  // A rod turned from z to x, and a ball.
  const double rod = 12, ball = 5;
  const double rod_along = rod * 0.5, rod_across = rod * (3 + 16) / 12.0, ball_own = ball * 0.4 * 4;
  expectMoments(
      "{type: assembly, parts: [{type: cylinder, radius: 1, height: 4, mass: 12, orientation: [1, 0, 1, 0]}, "
      "{type: ellipsoid, size: [4, 4, 4], mass: 5}]}",
      rod_along + ball_own, rod_across + ball_own, rod_across + ball_own);
  EXPECT_FALSE(readBody({"inertia: [1, 2, 3]"}).shape);
}

TEST(Shape, TypesAndKeys) {
  const std::string types = "box, ellipsoid, cylinder, t_handle, wingnut, l_shape, two_cylinders, assembly";
  expectKeyRefused("shape: {type: sphere, mass: 1}", ".shape.type",
                   {"got \"sphere\" (did you mean \"ellipsoid\"?)$", "expected one of " + types + ", got"});
  expectKeyRefused("shape: {type: bix, mass: 1}", ".shape.type",
                   {" (did you mean \"box\"?)$", "expected one of " + types + ", got"});
  expectKeyRefused("shape: {mass: 1}", ".shape", {"expected the key type, ", types});
  expectKeyRefused("shape: box", ".shape", {"got \"box\"$", "expected a shape, such as {type: box"});
  expectKeyRefused("shape: [1]", ".shape", {"got a list of 1$", "expected a shape"});
  const std::vector<std::pair<std::string, std::string>> keys = {
      {"box", "type, size, mass"},
      {"ellipsoid", "type, size, mass"},
      {"cylinder", "type, radius, height, mass"},
      {"t_handle", "type, bar_radius, bar_length, stem_radius, stem_length, mass"},
      {"wingnut", "type, hub_radius, hub_height, wing_size, dihedral, mass"},
      {"l_shape", "type, length_x, length_z, thickness, mass"},
      {"two_cylinders", "type, radius, height, second_radius, second_height, offset, mass"},
      {"assembly", "type, parts"}};
  for (const auto& [type, expected] : keys) {
    expectKeyRefused("shape: {type: " + type + ", density: 1}", ".shape.density",
                     {"got \"density\"$", "expected one of the keys " + expected + ", got"});
    expectKeyRefused("shape: {type: " + type + "}", ".shape", {"expected the key ", "got none$"});
  }
  expectKeyRefused("shape: {type: box, size: [1, 1, 1], mas: 1}", ".shape.mas", {" (did you mean \"mass\"?)$"});
  expectKeyRefused("shape: {type: box, size: [1, 1, 1]}", ".shape",
                   {"expected the key mass, a positive finite number (kg), got none$"});
}

TEST(Shape, EveryLengthAndMassIsPositive) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> shapes = {
      {"cylinder", {"radius", "height", "mass"}},
      {"t_handle", {"bar_radius", "bar_length", "stem_radius", "stem_length", "mass"}},
      {"wingnut", {"hub_radius", "hub_height", "mass"}},
      {"l_shape", {"length_x", "thickness", "length_z", "mass"}},
      {"two_cylinders", {"radius", "height", "second_radius", "second_height", "mass"}}};
  for (const auto& [type, keys] : shapes) {
    for (const std::string& bad : keys) {
      for (const std::string value : {"0", "-1", ".inf", "wide"}) {
        std::string text = "shape: {type: " + type;
        for (const std::string& key : keys) {
          text += ", " + key + ": " + (key == bad ? value : key == "thickness" ? "0.5" : "1");
        }
        if (type == "wingnut") text += ", wing_size: [1, 1, 1], dihedral: 0";
        if (type == "two_cylinders") text += ", offset: [0, 0, 0]";
        const std::string got = value == "wide" ? "\"wide\": not a decimal number$" : value + "$";
        const std::string unit = bad == "mass" ? "(kg)" : "(m)";
        expectKeyRefused(text + "}", ".shape." + bad, {"expected a positive finite number " + unit + ", got " + got});
      }
    }
  }
  expectKeyRefused("shape: {type: box, size: [1, 0, 1], mass: 1}", ".shape.size[1]",
                   {"got 0$", "expected a positive finite number (m)"});
  expectKeyRefused("shape: {type: ellipsoid, size: [1, 1], mass: 1}", ".shape.size",
                   {"got a list of 2$", "expected a list of 3 positive finite numbers (m)"});
  expectKeyRefused("shape: {type: wingnut, hub_radius: 1, hub_height: 1, wing_size: [-1, 1, 1], dihedral: 0, mass: 1}",
                   ".shape.wing_size[0]", {"got -1$"});
}

TEST(Shape, LNeedsAnUprightLongerThanItIsThick) {
  for (const char* length_z : {"0.5", "0.4"}) {
    expectKeyRefused(
        "shape: {type: l_shape, length_x: 1, length_z: " + std::string(length_z) + ", thickness: 0.5, mass: 1}",
        ".shape.length_z",
        {"expected a finite number above the thickness 0.5 (m), got " + std::string(length_z) + "$"});
  }
}

TEST(Shape, BadAssembliesAreRefused) {
  const std::string some = "a list of at least one part";
  expectKeyRefused("shape: {type: assembly, parts: []}", ".shape.parts", {"got an empty list$", some});
  expectKeyRefused("shape: {type: assembly, parts: 3}", ".shape.parts", {"got 3$", some});
  expectKeyRefused("shape: {type: assembly, parts: [box]}", ".shape.parts[0]", {"got \"box\"$", "expected a part"});
  expectKeyRefused("shape: {type: assembly, parts: [{size: [1, 1, 1], mass: 1}]}", ".shape.parts[0]",
                   {"expected the key type, ", "box, ellipsoid, cylinder"});
  expectKeyRefused("shape: {type: assembly, parts: [{type: wingnut, mass: 1}]}", ".shape.parts[0].type",
                   {"got \"wingnut\"$", "expected one of box, ellipsoid, cylinder, got"});
  expectKeyRefused(
      "shape: {type: assembly, parts: [{type: cylinder, size: [1, 1, 1], mass: 1}]}", ".shape.parts[0].size",
      {"got \"size\"$", "expected one of the keys type, radius, height, mass, position, orientation, got"});
  expectKeyRefused("shape: {type: assembly, parts: [{type: box, radius: 1, mass: 1}]}", ".shape.parts[0].radius",
                   {"got \"radius\"$", "expected one of the keys type, size, mass, position, orientation, got"});
  const std::string box = "shape: {type: assembly, parts: [{type: box, size: [1, 1, 1], mass: ";
  expectKeyRefused(box + "0}]}", ".shape.parts[0].mass", {"got 0$"});
  expectKeyRefused(box + "1, position: [0, 0]}]}", ".shape.parts[0].position", {"got a list of 2$"});
  expectKeyRefused(box + "1, orientation: [0, 0, 0, 0]}]}", ".shape.parts[0].orientation", {"a zero quaternion"});
  expectKeyRefused(box + "1, orientation: [1, 0, 0]}]}", ".shape.parts[0].orientation",
                   {"expected a list of 4", "got a list of 3$"});
}

TEST(Shape, WhatDoublesCannotHoldIsRefused) {
  for (const char* size : {"1e200", "1e-200"}) {
    const std::string three = "[" + std::string(size) + ", " + size + ", " + size + "]";
    expectKeyRefused("shape: {type: box, size: " + three + ", mass: 1}", ".shape",
                     {"expected lengths and masses", "got others: "});
  }
  expectKeyRefused(
      "shape: {type: assembly, parts: [{type: box, size: [0.001, 0.001, 0.001], mass: 1.7e308}, "
      "{type: box, size: [0.001, 0.001, 0.001], mass: 1.7e308}]}",
      ".shape", {"expected lengths and masses", "got masses that have no finite sum$"});
}
