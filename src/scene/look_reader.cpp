#include "look_reader.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "number.h"
#include "words.h"

namespace poinsot::scene {
namespace {

const std::vector<std::pair<std::string, Pictures>> kPictures = {{"both", Pictures::both},
                                                                 {"world", Pictures::world},
                                                                 {"body", Pictures::body},
                                                                 {"apart", Pictures::apart},
                                                                 {"none", Pictures::none}};

Pictures readPictures(const Place& place) {
  std::vector<std::string> words;
  for (const auto& [word, pictures] : kPictures) words.push_back(word);
  const std::string chosen = readChoice(place, words);
  for (const auto& [word, pictures] : kPictures) {
    if (word == chosen) return pictures;
  }
  return Pictures::as_it_suits;
}

/** Turns the attitude at the start so that L points upwards, and the part of ω across it towards a viewer at +x. */
void standUpright(const Place& place, Body& body) {
  if (!body.effects.empty()) {
    place.refuse("a body that no effect turns, whose L keeps its direction",
                 "one with " + nameOf(body.effects.front()));
  }
  const Eigen::Vector3d omega_principal = body.inertia.toPrincipal(body.omega_body);
  const Eigen::Vector3d momentum_body =
      body.inertia.toBody(body.inertia.moments().cwiseProduct(omega_principal.stableNormalized()));
  if (momentum_body.isZero(0)) place.refuse("a body that spins", "one at rest");
  const Eigen::Quaterniond upright =
      Eigen::Quaterniond::FromTwoVectors(body.attitude * momentum_body, Eigen::Vector3d::UnitZ()) * body.attitude;
  const Eigen::Vector3d omega = upright * body.omega_body;
  const double around = std::hypot(omega.x(), omega.y()) > 0 ? -std::atan2(omega.y(), omega.x()) : 0;
  body.attitude = (Eigen::AngleAxisd(around, Eigen::Vector3d::UnitZ()) * upright).normalized();
}

/** A type of drawing, and its keys besides `type`. */
struct DrawingType {
  std::string name;
  std::vector<std::string> keys;
};

constexpr std::size_t kMostPoints = 10000, kMostWords = 80;

}  // namespace

std::size_t lettersOf(const std::string& words) {
  return static_cast<std::size_t>(
      std::count_if(words.begin(), words.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

Eigen::Vector3d readColour(const Place& place) {
  const Eigen::Vector3d out = readVector(place, {Quantity::Range::not_negative, ""});
  if (out.maxCoeff() > 1) place.refuse("3 numbers from 0 to 1: red, green, blue", "[" + listed(out) + "]");
  return out;
}

Drawing readDrawing(const Place& place) {
  const std::vector<DrawingType> types = {{"line", {"points", "colour"}}, {"text", {"text", "position", "colour"}}};
  const Fields fields(place, "a drawing, such as {type: text, text: border, position: [0, 0, 1]}");
  Drawing out;
  if (fields.requireType(types).name == "line") {
    const char* const expected = "a list of at least two points";
    const Place points = fields.require("points", expected);
    points.requireList(expected, 2);
    if (points.node().size() > kMostPoints) {
      points.refuse("at most " + std::to_string(kMostPoints) + " points", std::to_string(points.node().size()));
    }
    for (std::size_t i = 0; i < points.node().size(); ++i) {
      out.points.push_back(readVector(points.item(i), quantity::kPosition));
    }
  } else {
    out.points = {requireVector(fields, "position", quantity::kPosition)};
    const char* const expected = "one line of words, of at most 80 characters";
    const Place words = fields.require("text", expected);
    if (!words.node().IsScalar()) words.refuse(expected, words.found());
    out.words = words.node().Scalar();
    if (out.words.empty() || lettersOf(out.words) > kMostWords || out.words.find('\n') != std::string::npos) {
      words.refuse(expected, words.found());
    }
  }
  if (const auto colour = fields.find("colour")) out.colour = readColour(*colour);
  return out;
}

void readLook(const Fields& fields, Body& body) {
  if (const auto pictures = fields.find("pictures")) body.pictures = readPictures(*pictures);
  if (const auto colour = fields.find("colour")) body.colour = readColour(*colour);
  if (const auto stand = fields.find("stand")) {
    readChoice(*stand, {"L_up"});
    standUpright(*stand, body);
  }
}

}  // namespace poinsot::scene
