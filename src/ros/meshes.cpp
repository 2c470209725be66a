#include "poinsot/ros/meshes.h"

#include <ros/package.h>

#include <filesystem>
#include <string>

#include "poinsot/scene/reader.h"

namespace poinsot::node {
namespace {

const std::string kPackage = "package://";

[[noreturn]] void refuse(const scene::Appearance& appearance, const std::string& problem) {
  throw scene::Error(appearance.place + appearance.mesh + ": " + problem +
                     "; allowed: a mesh that is there, such as package://poinsot/meshes/book.dae");
}

}  // namespace

void requireMeshes(const scene::Scene& scene) {
  for (const scene::Body& body : scene.bodies) {
    if (!body.appearance || body.appearance->mesh.compare(0, kPackage.size(), kPackage) != 0) continue;
    const std::string rest = body.appearance->mesh.substr(kPackage.size());
    const std::size_t slash = rest.find('/');
    const std::string package = rest.substr(0, slash);
    const std::string folder = ros::package::getPath(package);
    if (folder.empty()) refuse(*body.appearance, "there is no package " + package + " in ROS_PACKAGE_PATH");
    const std::string file = folder + rest.substr(slash);
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) refuse(*body.appearance, "there is no file " + file);
  }
}

}  // namespace poinsot::node
