#include "poinsot/scene/reader.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "body_reader.h"
#include "document.h"
#include "fields.h"
#include "look_reader.h"
#include "number.h"
#include "poinsot/scene/message.h"
#include "text_file.h"

namespace poinsot::scene {
namespace {

const char* const kWorldFrame = "world";
constexpr double kShortestLoop = 0.1;  // s: several ticks
constexpr double kFarthestSeen = 1e5;  // m: floats lie 8 mm apart there

/** Which body has which frame. */
class Frames {
 public:
  /** Adds the frames of a body; refuses the body if another, or the world, has one of them already. */
  void claim(const std::string& body, const Place& name) {
    for (const char* suffix : {"", "_space", "_model", "_space_body"}) {
      const std::string frame = body + suffix;
      const auto [taken, is_new] = owners_.emplace(frame, body);
      if (is_new) continue;
      if (taken->second == body) name.refuse("a name that no other body has", name.found() + " a second time");
      const std::string owner = frame == kWorldFrame ? "the fixed frame" : "a frame of the body " + taken->second;
      name.refuse("a name that keeps <name>, <name>_space, <name>_model and <name>_space_body apart from other frames",
                  name.found(), "the frame " + frame + " of the body " + body + " is also " + owner);
    }
  }

 private:
  std::map<std::string, std::string> owners_ = {{kWorldFrame, ""}};  // frame → body
};

/** Warns of bodies that start in one place and are drawn into each other, which is seldom meant. */
void warnOfBodiesInOnePlace(const Place& bodies, Scene& scene) {
  const auto placeOf = [](const Body& body) -> std::array<double, 3> {
    if (!body.translation) return {0, 0, 0};
    const Eigen::Vector3d& p = body.translation->position;
    return {p.x(), p.y(), p.z()};
  };
  std::map<std::array<double, 3>, std::string> first_there;  // its name
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const auto [first, is_free] = first_there.emplace(placeOf(scene.bodies[i]), scene.bodies[i].name);
    if (is_free) continue;
    scene.warnings.push_back(
        bodies.item(i)
            .called(scene.bodies[i].name)
            .message("starts where " + first->second +
                     " does and is drawn into it; an effect of type translation with a position sets them apart"));
  }
}

/** Warns of bodies so far away that the floats of viewers lie too far apart to draw a body of some metres. */
void warnOfFarBodies(const Place& bodies, Scene& scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (!body.translation) continue;
    const double distance = body.translation->position.stableNorm();
    if (!(distance > kFarthestSeen)) continue;
    const auto seen = static_cast<float>(distance);
    const double spacing = std::nextafter(seen, std::numeric_limits<float>::infinity()) - seen;
    scene.warnings.push_back(bodies.item(i).called(body.name).message(
        "starts " + numberText(distance, 3) + " m from the origin of frame world, where the floats of RViz lie " +
        numberText(spacing, 2) + " m apart, so that it is not seen there; better: a position near the origin, or " +
        body.name + "_space as RViz's fixed frame"));
  }
}

Scene readScene(const Place& top, const ReadOptions& options) {
  const Fields fields(top, kExpectedScene);
  fields.allowOnly({"rate", "loop", "bodies", "drawings"});

  Scene scene;
  if (const auto rate = fields.find("rate")) scene.rate = readNumber(*rate, quantity::kRate);
  if (const auto loop = fields.find("loop")) {
    scene.loop = readNumber(*loop, quantity::kDuration);
    if (*scene.loop < kShortestLoop) {
      loop->refuse("at least " + numberText(kShortestLoop) + " s", numberText(*scene.loop) + " s");
    }
  }

  const char* const expected = "a list of at least one body";
  const Place bodies = fields.require("bodies", expected);
  bodies.requireList(expected, 1);
  Frames frames;
  for (std::size_t i = 0; i < bodies.node().size(); ++i) {
    const Place place = bodies.item(i);
    scene.bodies.push_back(readBody(place, options, scene.warnings));
    const std::string& name = scene.bodies.back().name;
    frames.claim(name, place.called(name).under(YAML::Node("name"), place.node()["name"]));
  }
  if (const auto drawings = fields.find("drawings")) {
    drawings->requireList("a list of at least one line or text", 1);
    for (std::size_t i = 0; i < drawings->node().size(); ++i) {
      scene.drawings.push_back(readDrawing(drawings->item(i)));
    }
  }
  warnOfBodiesInOnePlace(bodies, scene);
  warnOfFarBodies(bodies, scene);
  return scene;
}

}  // namespace

YAML::Node readDocument(const std::string& path) {
  return parseDocument(readTextFile(path), path);
}

Scene readFile(const std::string& path, const ReadOptions& options) {
  return readTree(readDocument(path), path, options);
}

Scene readTree(const YAML::Node& tree, const std::string& source, const ReadOptions& options) {
  if (!tree.IsDefined()) throw Error(source + ": " + expectedGot(kExpectedScene, "nothing"));
  return readScene(Place(tree, source), options);
}

double readStep(const YAML::Node& node, const std::string& source) {
  return readNumber(Place(node, source), quantity::kStep);
}

double readRate(const YAML::Node& node, const std::string& source) {
  return readNumber(Place(node, source), quantity::kRate);
}

}  // namespace poinsot::scene
