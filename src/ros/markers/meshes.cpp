#include "poinsot/ros/markers/meshes.h"

#include <ros/package.h>

#include <boost/algorithm/string/predicate.hpp>
#include <filesystem>
#include <string>

#include "poinsot/scene/reader.h"

namespace poinsot::node {
namespace {

using boost::algorithm::starts_with;

const std::string kPackage = "package://";
const std::string kFile = "file://";

/** package://<name>/<path> */
struct PackageFile {
  explicit PackageFile(const std::string& mesh) {
    const std::string rest = mesh.substr(kPackage.size());
    const std::size_t slash = rest.find('/');
    package = rest.substr(0, slash);
    folder = ros::package::getPath(package);
    path = folder + rest.substr(slash);
  }
  std::string package, folder, path;  ///< folder: empty where there is no such package
};

[[noreturn]] void refuse(const scene::Appearance& appearance, const std::string& problem) {
  throw scene::Error(appearance.place +
                     "expected the address of a mesh, such as package://poinsot/meshes/book.dae, got " +
                     appearance.mesh + ": " + problem);
}

}  // namespace

void requireMeshes(const scene::Scene& scene) {
  for (const scene::Body& body : scene.bodies) {
    if (!body.appearance || !starts_with(body.appearance->mesh, kPackage)) continue;
    const PackageFile file(body.appearance->mesh);
    if (file.folder.empty()) refuse(*body.appearance, "there is no package " + file.package + " in ROS_PACKAGE_PATH");
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file.path, ignored))
      refuse(*body.appearance, "there is no file " + file.path);
  }
}

std::string meshAddress(const std::string& mesh) {
  const std::string path = starts_with(mesh, kPackage) ? PackageFile(mesh).path
                           : starts_with(mesh, kFile)  ? mesh.substr(kFile.size())
                                                       : "";
  if (path.find(' ') == std::string::npos) return mesh;
  std::string address = kFile;
  for (const char c : path) {
    address += c == ' ' ? "%20" : c == '%' ? "%25" : std::string(1, c);
  }
  return address;
}

}  // namespace poinsot::node
