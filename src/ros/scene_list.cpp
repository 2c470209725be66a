#include "poinsot/ros/scene_list.h"

#include <ros/package.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "poinsot/scene/message.h"

namespace poinsot::node {
namespace {

constexpr const char* kEnding = ".yaml";

std::filesystem::path directory() {
  return std::filesystem::path(ros::package::getPath("poinsot")) / "scenes";
}

[[noreturn]] void refuse(const std::string& got) {
  const std::vector<std::string> names = sceneNames();
  throw std::invalid_argument("scene: " +
                              scene::expectedGot("the path of a scene file or one of " + scene::joined(names),
                                                 '"' + got + '"' + scene::didYouMean(got, names)));
}

}  // namespace

std::vector<std::string> sceneNames() {
  std::vector<std::string> out;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(directory(), none)) {
    if (entry.path().extension() == kEnding) out.push_back(entry.path().stem().string());
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string sceneFile(const std::string& name_or_path) {
  if (name_or_path.find('/') != std::string::npos || std::filesystem::path(name_or_path).extension() == kEnding) {
    return name_or_path;
  }
  const std::vector<std::string> names = sceneNames();
  if (std::find(names.begin(), names.end(), name_or_path) != names.end()) {
    return (directory() / (name_or_path + kEnding)).string();
  }
  refuse(name_or_path);
}

void requireKnownScene(const std::string& path) {
  const std::filesystem::path file(path);
  std::error_code none;
  if (file.extension() != kEnding || std::filesystem::exists(file, none) ||
      !std::filesystem::equivalent(file.parent_path(), directory(), none)) {
    return;
  }
  refuse(sceneName(path));
}

std::string sceneName(const std::string& file) {
  return std::filesystem::path(file).stem().string();
}

}  // namespace poinsot::node
