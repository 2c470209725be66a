#include <clocale>
#include <limits>
#include <locale>

#include "scene_text.h"

using scene_text::expectKeyRefused;
using scene_text::readBody;

namespace {

double firstOmega(const std::string& number) {
  return readBody({"angular_velocity: [" + number + ", 0, 0]"}).omega_body.x();
}

void expectNotANumber(const std::string& number, const std::string& why) {
  expectKeyRefused("angular_velocity: [0, " + number + ", 0]", ".angular_velocity[1]",
                   {why + "$", "expected a finite number (rad/s)"});
}

/** A decimal comma, as a German locale would have. */
struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

}  // namespace

TEST(Numbers, DecimalNotationsOfOneGrammar) {
  EXPECT_EQ(firstOmega("1"), 1.0);
  EXPECT_EQ(firstOmega("+1"), 1.0);
  EXPECT_EQ(firstOmega("-1"), -1.0);
  EXPECT_EQ(firstOmega("0"), 0.0);
  EXPECT_EQ(firstOmega("1."), 1.0);
  EXPECT_EQ(firstOmega(".5"), 0.5);
  EXPECT_EQ(firstOmega("-.5"), -0.5);
  EXPECT_EQ(firstOmega("+.5e1"), 5.0);
  EXPECT_EQ(firstOmega("0.1"), 0.1);
  EXPECT_EQ(firstOmega("00.5"), 0.5);
  EXPECT_EQ(firstOmega("1e-9"), 1e-9);
  EXPECT_EQ(firstOmega("1E+9"), 1e9);
  EXPECT_EQ(firstOmega("1.e3"), 1000.0);
  EXPECT_EQ(firstOmega("1.5e03"), 1500.0);
  EXPECT_EQ(firstOmega("12345678901234567890"), 12345678901234567890.0);
  EXPECT_EQ(firstOmega("0.10000000000000000555"), 0.1);
  EXPECT_EQ(firstOmega("0.30000000000000004"), 0.30000000000000004);
}

TEST(Numbers, QuotesDoNotMatter) {
  EXPECT_EQ(firstOmega("'1e-9'"), 1e-9);
  EXPECT_EQ(firstOmega("\"2.5\""), 2.5);
  expectNotANumber("'0x10'", "got 0x10: not a decimal number");
  expectNotANumber("''", "got \"\": not a decimal number");
  expectNotANumber("' 1'", "got \" 1\": not a decimal number");
}

TEST(Numbers, EndsOfTheRange) {
  EXPECT_EQ(firstOmega("1e100"), 1e100);
  // Beside a larger component, since alone it would have no energy that doubles hold.
  EXPECT_EQ(readBody({"angular_velocity: [4.9e-324, 1, 0]"}).omega_body.x(), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(firstOmega("1e-400"), 0.0);
  EXPECT_EQ(firstOmega("-1e-400"), 0.0);
  for (const char* number : {"1e999", "-1e999", "1.8e308", "1.0e+999"}) {
    expectNotANumber(number, "got " + std::string(number) + ": not finite in double precision");
  }
}

TEST(Numbers, NamesOfTheNonFiniteAreCalledSo) {
  for (const char* number : {".inf", "-.inf", "+.INF", ".nan", ".NaN", "nan", "NAN", "inf", "-inf", "Infinity"}) {
    const std::string text = number;
    expectNotANumber(number, "got " + (std::string("nNiI").find(text[0]) < 4 ? "\"" + text + "\"" : text));
  }
}

TEST(Numbers, WhatReadersUnderstandDifferentlyIsRefused) {
  for (const char* number :
       {"0x10", "0o10",  "1_000", "1:30", "190:20:30.15", "0b11", "0x1p3", "1e",  "1e+", "e5",      ".",   "+", "-",
        "--1",  "1.2.3", "1 2",   "1d5",  "1f",           "true", "False", "yes", "off", "deg(90)", "one", "١"}) {
    expectNotANumber(number, ": not a decimal number");
  }
  expectNotANumber("'1,5'", "got 1,5: not a decimal number");
  for (const char* number : {"010", "-010", "+07", "00", "09"}) {
    expectNotANumber(number, "got " + std::string(number) + ": some readers take the leading zero as octal");
  }
}

TEST(Numbers, OtherKindsOfNodesAreRefused) {
  expectNotANumber("null", "got null");
  expectNotANumber("~", "got null");
  expectNotANumber("[1]", "got a list of 1");
  expectNotANumber("{a: 1}", "got a map");
  expectKeyRefused("angular_velocity: [0, !degrees 90, 0]", ".angular_velocity[1]",
                   {"expected no tags, got the tag !degrees$"});
  expectKeyRefused("angular_velocity: [0, !!float 1, 0]", ".angular_velocity[1]", {"the tag", "expected no tags"});
}

TEST(Numbers, LongValuesAreShortenedInMessages) {
  expectNotANumber("x" + std::string(500, 'y'), "yyyyyyyyyy…\": not a decimal number");
}

TEST(Numbers, TheLocaleDoesNotMatter) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  EXPECT_EQ(firstOmega("1234.5"), 1234.5);
  const auto scene = scene_text::read(scene_text::body({"inertia: [1000, 2000.5, 4000]"}));
  std::locale::global(before);
  EXPECT_EQ(scene.bodies[0].inertia.moments(), Eigen::Vector3d(1000, 2000.5, 4000));
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("1000, 2000.5, 4000"), std::string::npos) << scene.warnings[0];
}

TEST(Numbers, ListsOfTheWrongLength) {
  const std::string expected = "expected a list of 3 finite numbers (rad/s)";
  expectKeyRefused("angular_velocity: []", ".angular_velocity", {"got an empty list$", expected});
  expectKeyRefused("angular_velocity: [1, 2]", ".angular_velocity", {"got a list of 2$", expected});
  expectKeyRefused("angular_velocity: [1, 2, 3, 4]", ".angular_velocity", {"got a list of 4$", expected});
  expectKeyRefused("angular_velocity: 1", ".angular_velocity", {"got 1$", expected});
  expectKeyRefused("angular_velocity: {x: 1}", ".angular_velocity", {"got a map$", expected});
  expectKeyRefused("angular_velocity:", ".angular_velocity", {"got null$", expected});
}
