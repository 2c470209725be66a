#include "appearance_reader.h"

#include <algorithm>
#include <filesystem>

#include "characters.h"
#include "fields.h"
#include "number.h"

namespace poinsot::scene {
namespace {

const char* const kExpectedAppearance = "a mesh and how it lies, such as {mesh: package://poinsot/meshes/book.dae}";
const char* const kExpectedMesh = "package://<package>/<path> or file:///<path> of a COLLADA or STL mesh (.dae, .stl)";
const std::string kPackage = "package://", kFile = "file:///";

bool startsWith(const std::string& text, const std::string& head) {
  return text.compare(0, head.size(), head) == 0;
}

/** Whether a text ends in .dae or .stl, in capitals or not: RViz takes both. */
bool endsAsMesh(const std::string& text) {
  const std::string tail = lower(text.substr(text.size() - std::min<std::size_t>(text.size(), 4)));
  return tail == ".dae" || tail == ".stl";
}

/** Whether a text begins with package://, a name that a ROS package may have, and a slash. */
bool namesPackage(const std::string& text) {
  const std::size_t slash = text.find('/', kPackage.size());
  if (!startsWith(text, kPackage) || slash == std::string::npos || slash == kPackage.size()) return false;
  return std::all_of(text.begin() + static_cast<std::ptrdiff_t>(kPackage.size()),
                     text.begin() + static_cast<std::ptrdiff_t>(slash),
                     [](char c) { return isLetter(c) || isDigit(c) || c == '_' || c == '-'; });
}

std::string readMesh(const Place& place) {
  const std::string& mesh = place.scalar();
  if (!(startsWith(mesh, kFile) || namesPackage(mesh)) || !endsAsMesh(mesh)) place.refuse(kExpectedMesh, place.found());
  std::error_code ignored;
  if (startsWith(mesh, kFile) && !std::filesystem::is_regular_file(mesh.substr(kFile.size() - 1), ignored)) {
    place.refuse(kExpectedMesh, place.found(), "there is no such file");
  }
  return mesh;
}

}  // namespace

Appearance readAppearance(const Place& place) {
  const Fields fields(place, kExpectedAppearance);
  fields.allowOnly({"mesh", "scale", "position", "orientation"});
  const Place mesh = fields.require("mesh", kExpectedMesh);
  Appearance out;
  out.mesh = readMesh(mesh);
  out.place = mesh.message("");
  if (const auto scale = fields.find("scale")) {
    out.scale = scale->node().IsSequence() ? readVector(*scale, quantity::kScale)
                                           : Eigen::Vector3d::Constant(readNumber(*scale, quantity::kScale));
  }
  if (const auto position = fields.find("position")) out.position = readVector(*position, quantity::kPosition);
  if (const auto orientation = fields.find("orientation")) out.orientation = readRotation(*orientation);
  return out;
}

}  // namespace poinsot::scene
