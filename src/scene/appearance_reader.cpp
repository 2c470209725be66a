#include "appearance_reader.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "fields.h"
#include "number.h"

namespace poinsot::scene {
namespace {

const char* const kAllowedAppearance = "a mesh and how it lies, such as {mesh: package://poinsot/meshes/book.dae}";
const char* const kAllowedMesh = "package://<package>/<path> or file:///<path> of a COLLADA or STL mesh (.dae, .stl)";
const std::string kPackage = "package://", kFile = "file:///";

bool startsWith(const std::string& text, const std::string& head) {
  return text.compare(0, head.size(), head) == 0;
}

/** In capitals or not, as RViz takes it. @param tail in small letters. */
bool endsWith(const std::string& text, const std::string& tail) {
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  return text.size() > tail.size() &&
         std::equal(tail.begin(), tail.end(), text.end() - static_cast<std::ptrdiff_t>(tail.size()),
                    [&](char b, char a) { return same(a, b); });
}

/** package://, a name that a ROS package may have, a slash, and something. */
bool namesPackage(const std::string& text) {
  const std::size_t slash = text.find('/', kPackage.size());
  if (!startsWith(text, kPackage) || slash == std::string::npos || slash == kPackage.size()) return false;
  return std::all_of(text.begin() + static_cast<std::ptrdiff_t>(kPackage.size()),
                     text.begin() + static_cast<std::ptrdiff_t>(slash),
                     [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
}

std::string readMesh(const Place& place) {
  const std::string found = place.found();
  if (!place.node().IsScalar()) place.refuse(found + " is no mesh", kAllowedMesh);
  const std::string mesh = place.node().Scalar();
  if (!startsWith(mesh, kFile) && !namesPackage(mesh)) {
    place.refuse(found + " begins with neither package://<package>/ nor file:///", kAllowedMesh);
  }
  if (!endsWith(mesh, ".dae") && !endsWith(mesh, ".stl")) {
    place.refuse(found + " ends with neither .dae nor .stl", kAllowedMesh);
  }
  std::error_code ignored;
  if (startsWith(mesh, kFile) && !std::filesystem::is_regular_file(mesh.substr(kFile.size() - 1), ignored)) {
    place.refuse(found + ": there is no such file", kAllowedMesh);
  }
  return mesh;
}

}  // namespace

Appearance readAppearance(const Place& place) {
  const Fields fields(place, kAllowedAppearance);
  fields.allowOnly({"mesh", "scale", "position", "orientation"});
  const Place mesh = fields.require("mesh", kAllowedMesh);
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
