#include "scene_text.h"

using scene_text::expectKeyRefused;
using scene_text::readBody;

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
                   {"a list of 2 is too short", "allowed: a list of 3 finite numbers (m)"});
  expectKeyRefused("effects: [{type: translation, velocity: [1, x, 2]}]", ".effects[0].velocity[1]",
                   {"x is not a decimal number", "allowed: a finite number (m/s)"});
  expectKeyRefused("effects: [{type: translation, acceleration: [.nan, 0, 2]}]", ".effects[0].acceleration[0]",
                   {".nan is not finite", "allowed: a finite number (m/s²)"});
  expectKeyRefused("effects: [{type: translation, mass: 1}]", ".effects[0].mass",
                   {"unknown key", "allowed: type, position, velocity, acceleration"});
  expectKeyRefused("effects: [{type: translation}, {type: translation}]", ".effects[1]",
                   {"a second translation", "allowed: one translation a body"});
}

TEST(Effects, TypesOfOtherVersionsAreToldFromUnknownOnes) {
  for (const std::string type : {"constant_torque", "gravity_torque", "gravity_gradient", "viscous_damping",
                                 "internal_dissipation", "torque_schedule"}) {
    expectKeyRefused("effects: [{type: " + type + ", frame: body, torque: [0, 0, 1]}]", ".effects[0].type",
                     {type + " is not in this version", "allowed: translation"});
  }
  expectKeyRefused("effects: [{type: magnetism}]", ".effects[0].type",
                   {"magnetism is unknown;", "allowed: translation"});
  expectKeyRefused("effects: [{type: transaltion}]", ".effects[0].type",
                   {"did you mean \"translation\"?", "allowed: translation"});
}

TEST(Effects, AreAListOfMapsWithAType) {
  expectKeyRefused("effects: {type: translation}", ".effects", {"a map is not a list", "a list of effects"});
  expectKeyRefused("effects:", ".effects", {"null is not a list", "a list of effects"});
  expectKeyRefused("effects: [translation]", ".effects[0]", {"translation is not a map", "allowed: an effect"});
  expectKeyRefused("effects: [{position: [0, 0, 0]}]", ".effects[0]", {"type is missing", "translation"});
}
