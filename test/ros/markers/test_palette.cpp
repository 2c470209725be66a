#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "poinsot/ros/markers/palette.h"

namespace poinsot::node {
namespace {

using std_msgs::ColorRGBA;

/** Relative luminance, WCAG 2.1. */
double luminance(const ColorRGBA& c) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}
double contrast(const ColorRGBA& a, const ColorRGBA& b) {
  const double x = luminance(a) + 0.05, y = luminance(b) + 0.05;
  return std::max(x, y) / std::min(x, y);
}
ColorRGBA bytes(int r, int g, int b) {
  const auto share = [](int byte) { return static_cast<float>(byte) / 255.f; };
  return palette::colour(share(r), share(g), share(b));
}

// The views' backgrounds.
const ColorRGBA kDark = bytes(24, 28, 36), kLight = bytes(236, 239, 244);

TEST(Palette, contrastIsWhatWcagSays) {
  EXPECT_NEAR(contrast(bytes(0, 0, 0), bytes(255, 255, 255)), 21, 1e-3);
  EXPECT_NEAR(contrast(bytes(255, 255, 255), bytes(119, 119, 119)), 4.48, 0.01);
}

TEST(Palette, textReadsOnDarkAndOnLight) {  // WCAG 2.1, AA
  for (const ColorRGBA& c : {palette::kLabel, palette::kOmega, palette::kAngularMomentum, palette::kTorque,
                             palette::kGravity, palette::kEnergy, palette::kMomentumName, palette::kPolhode}) {
    EXPECT_GE(contrast(palette::asText(c, false), kDark), 4.5) << c;
    EXPECT_GE(contrast(palette::asText(c, true), kLight), 4.5) << c;
  }
  EXPECT_LT(contrast(palette::kPolhode, kLight), 2) << "white as it is would not";
  EXPECT_LT(contrast(palette::kAngularMomentum, kDark), 4.5) << "nor would the green of arrows";
  EXPECT_EQ(palette::asText(palette::kPolhode, false), palette::kPolhode) << "what can be read stays as it is";
}

TEST(Palette, arrowsAndLinesThatLeaveTheEllipsoidsDoSoToo) {
  for (const ColorRGBA& c : {palette::kOmega, palette::kAngularMomentum, palette::kTorque, palette::kGravity,
                             palette::kPath, palette::kPivot, palette::kBodyCone, palette::kSpaceCone}) {
    EXPECT_GE(contrast(c, kDark), 2) << c;
    EXPECT_GE(contrast(c, kLight), 2) << c;
  }
}

TEST(Palette, linesReadOnBothEllipsoids) {
  for (const ColorRGBA& surface : {palette::kEnergy, palette::kMomentumEllipsoid}) {
    EXPECT_GE(contrast(palette::kPolhode, surface), 2);
    EXPECT_GE(contrast(palette::kSeparatrix, surface), 2);
  }
  EXPECT_GE(contrast(palette::kPolhodeFamily, palette::kMomentumEllipsoid), 2);
}

/** As somebody sees it who lacks one kind of cone: Viénot, Brettel & Mollon 1999; linear RGB. */
Eigen::Vector3d without(const ColorRGBA& c, bool red) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  const Eigen::Vector3d rgb(linear(c.r), linear(c.g), linear(c.b));
  const double a = red ? 0.11238 : 0.29275, b = red ? 0.88762 : 0.70725, d = red ? 0.00401 : -0.02234;
  const double yellow = a * rgb[0] + b * rgb[1];
  return {yellow, yellow, d * rgb[0] - d * rgb[1] + rgb[2]};
}

TEST(Palette, theColourBlindTellTheQuantitiesApart) {
  const std::pair<const char*, ColorRGBA> quantities[] = {{"energy", palette::kEnergy},
                                                          {"momentum ellipsoid", palette::kMomentumEllipsoid},
                                                          {"omega", palette::kOmega},
                                                          {"L", palette::kAngularMomentum}};
  for (const bool red : {false, true}) {
    for (const auto& a : quantities) {
      for (const auto& b : quantities) {
        if (a.first == b.first) continue;
        EXPECT_GT((without(a.second, red) - without(b.second, red)).norm(), 0.05) << a.first << " and " << b.first;
      }
    }
  }
}

}  // namespace
}  // namespace poinsot::node
