// Include paths alone cannot keep rooms apart: on Debian the headers of ROS and yaml-cpp lie in the system's include
// path, so that any room could include them.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/** The path of an #include line, empty for any other line. */
std::string includeOf(const std::string& line) {
  static const std::regex pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"].*)");
  std::smatch match;
  return std::regex_match(line, match, pattern) ? match[1].str() : "";
}

bool matches(const std::string& include, const std::string& pattern) {
  return std::regex_search(include, std::regex(pattern));
}

/** ROS: its libraries, anybody's messages, this package's messages, and the rooms that know ROS. */
bool isRos(const std::string& include) {
  return matches(
             include,
             R"(^(ros|rosbag|rosconsole|rosgraph|roscpp|tf|tf2|tf2_\w+|topic_tools|xmlrpcpp|XmlRpc\w*|rviz|pluginlib)"
             R"(|diagnostic_updater|dynamic_reconfigure|interactive_markers|message_filters|nodelet|cpp_common)/)") ||
         matches(include, R"(^(\w+_)?(msgs|srvs)/|^XmlRpc|^poinsot/([A-Z]\w*\.h|ros/|audit/))");
}

bool isYaml(const std::string& include) {
  return matches(include, R"(^(yaml-cpp/|yaml\.h))");
}

/** "file:line includes x" for each include of a room (in include/ and src/) that is not allowed there. */
std::vector<std::string> offences(const std::string& room, bool (*forbidden)(const std::string&), int* files) {
  std::vector<std::string> out;
  for (const fs::path& root : {fs::path(SOURCE_DIR) / "include/poinsot" / room, fs::path(SOURCE_DIR) / "src" / room}) {
    if (!fs::exists(root)) continue;  // core's public headers alone are in include/
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      const std::string ending = entry.path().extension();
      if (ending != ".h" && ending != ".hpp" && ending != ".cpp") continue;
      ++*files;
      std::ifstream in(entry.path());
      std::string line;
      for (int number = 1; std::getline(in, line); ++number) {
        const std::string include = includeOf(line);
        if (!include.empty() && forbidden(include)) {
          out.push_back(entry.path().string() + ":" + std::to_string(number) + " includes " + include);
        }
      }
    }
  }
  return out;
}

void expectPure(const std::string& room, bool (*forbidden)(const std::string&)) {
  int files = 0;
  for (const std::string& offence : offences(room, forbidden, &files)) ADD_FAILURE() << offence;
  EXPECT_GT(files, 0) << "no file found in room " << room;
}

bool isRosOrYaml(const std::string& include) {
  return isRos(include) || isYaml(include);
}

TEST(Rooms, coreIncludesNeitherRosNorYaml) {
  expectPure("core", isRosOrYaml);
}
TEST(Rooms, viewIncludesNeitherRosNorYaml) {
  expectPure("view", isRosOrYaml);
}
TEST(Rooms, sceneIncludesNoRos) {
  expectPure("scene", isRos);
}
TEST(Rooms, costIncludesNoRos) {
  expectPure("cost", isRos);
}
TEST(Rooms, sessionIncludesNoRos) {
  expectPure("session", isRos);
}

// Include paths do not hold a path that leads out of the room.
TEST(Rooms, noIncludeLeadsOutOfItsRoom) {
  int relative = 0;
  for (const auto& room : fs::directory_iterator(fs::path(SOURCE_DIR) / "src")) {
    const std::string inside = room.path().string() + "/";
    for (const auto& entry : fs::recursive_directory_iterator(room.path())) {
      std::ifstream in(entry.path());
      for (std::string line; entry.is_regular_file() && std::getline(in, line);) {
        const std::string include = includeOf(line);
        if (include.rfind("../", 0) != 0) continue;
        ++relative;
        const std::string leads_to = (entry.path().parent_path() / include).lexically_normal().string();
        EXPECT_EQ(leads_to.compare(0, inside.size(), inside), 0) << entry.path() << " includes " << include;
      }
    }
  }
  EXPECT_GT(relative, 0) << "nothing was looked at";
}

// Another installed copy of the package would be on its include path.
TEST(Rooms, auditIncludesNoOtherRoom) {
  expectPure("audit", [](const std::string& include) {
    return matches(include, "^poinsot/[a-z_]+/") && !matches(include, "^poinsot/audit/");
  });
}

TEST(Rooms, includesAreRecognised) {
  EXPECT_EQ(includeOf("#include <ros/ros.h>"), "ros/ros.h");
  EXPECT_EQ(includeOf("  #  include \"poinsot/view/curve.h\"  // why"), "poinsot/view/curve.h");
  EXPECT_EQ(includeOf("// #include <ros/ros.h>"), "");
  EXPECT_EQ(includeOf("include the ros/ros.h"), "");
}

TEST(Rooms, aStrayIncludeWouldBeCaught) {
  for (const char* bad : {"ros/ros.h", "ros/console.h", "tf2/utils.h", "tf2_ros/buffer.h", "tf2_eigen/tf2_eigen.h",
                          "geometry_msgs/Pose.h", "std_msgs/Header.h", "visualization_msgs/MarkerArray.h",
                          "std_srvs/Trigger.h", "rosbag/bag.h", "poinsot/BodyState.h", "poinsot/BodyDescription.h",
                          "poinsot/ros/names.h", "poinsot/audit/check.h", "XmlRpcValue.h", "xmlrpcpp/XmlRpcValue.h"}) {
    EXPECT_TRUE(isRos(bad)) << bad;
  }
  for (const char* good : {"cmath", "Eigen/Core", "poinsot/core/motion.h", "poinsot/scene/scene.h",
                           "boost/math/constants/constants.hpp", "yaml-cpp/yaml.h"}) {
    EXPECT_FALSE(isRos(good)) << good;
  }
  EXPECT_TRUE(isYaml("yaml-cpp/yaml.h"));
  EXPECT_FALSE(isYaml("poinsot/scene/scene.h"));
}

/** Returns the match of the pattern's group in each line that a command prints. */
std::vector<std::string> printedBy(const std::string& command, const std::regex& pattern) {
  std::vector<std::string> out;
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return out;
  std::array<char, 4096> line;
  while (std::fgets(line.data(), line.size(), pipe)) {
    const std::string text = line.data();
    std::smatch match;
    if (std::regex_search(text, match, pattern)) out.push_back(match[1]);
  }
  pclose(pipe);
  return out;
}

/** Returns the libraries that a shared library needs directly (C libraries of the system may need any others). */
std::vector<std::string> neededBy(const std::string& library) {
  return printedBy("readelf -d '" + library + "'", std::regex(R"(\(NEEDED\).*\[(.+)\])"));
}

// Inline functions of Eigen, Boost or the standard library that core exported would be those of every program that
// links it, whatever flags that is compiled with; and the program's would be core's.
TEST(Rooms, coreExportsItsOwnNamesOnly) {
  const std::vector<std::string> names =
      printedBy("nm -D -C --defined-only '" + std::string(CORE_LIBRARY) + "'", std::regex(R"(^\w* +\w +(.*))"));
  EXPECT_GT(names.size(), 50U) << "nm said little about " << CORE_LIBRARY;
  for (const std::string& name : names) {
    EXPECT_TRUE(matches(name, "^((typeinfo|typeinfo name|vtable) for )?poinsot::")) << name;
    EXPECT_FALSE(matches(name, "^poinsot::(closed_form|taylor)::")) << name << " is private to core";
  }
}

/** Each line of core's public headers. */
template <class Use>
void eachPublicLine(const Use& use) {
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(SOURCE_DIR) / "include/poinsot/core")) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path());
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
      use(line, entry.path().string() + ":" + std::to_string(number));
    }
  }
}

// Boost is linked privately, so that users of core need not have it.
TEST(Rooms, publicHeadersIncludeEigenAndTheStandardLibraryOnly) {
  int includes = 0;
  eachPublicLine([&](const std::string& line, const std::string& place) {
    const std::string include = includeOf(line);
    if (include.empty()) return;
    ++includes;
    EXPECT_TRUE(matches(include, "^(Eigen/|poinsot/core/|[a-z]+$)")) << place << " includes " << include;
  });
  EXPECT_GT(includes, 0);
}

// Types that Eigen aligns as the compiler's flags say; see eigen_types.h.
TEST(Rooms, publicHeadersNameNoTypeWhoseLayoutDependsOnFlags) {
  const std::string aligned =
      R"(Eigen::(Quaterniond|Quaternion<double>|(Vector|RowVector|Array)[24][dfi]|(Matrix|Array)(2|4|22|44)[dfi])"
      R"(|(Matrix|Vector|RowVector|Array)X+[dfi]|(Isometry|Affine|Projective)[23][df])\b)";
  for (const char* bad :
       {"  Eigen::Quaterniond q;", "Eigen::Vector4d v", "Eigen::MatrixXd", "Eigen::Isometry3d pose"}) {
    EXPECT_TRUE(matches(bad, aligned)) << bad;
  }
  for (const char* good : {"Eigen::Vector3d", "Eigen::Matrix3d", "Quaternion", "Vector4"}) {
    EXPECT_FALSE(matches(good, aligned)) << good;
  }
  eachPublicLine([&](const std::string& line, const std::string& place) {
    EXPECT_FALSE(matches(line, aligned)) << place << ": " << line;
  });
}

std::string contentOf(const fs::path& file) {
  std::ifstream in(fs::path(SOURCE_DIR) / file);
  return std::string((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
}

TEST(Rooms, coreLinksTheBoostThatItIncludes) {
  EXPECT_TRUE(matches(contentOf("src/core/CMakeLists.txt"), R"(target_link_libraries\(poinsot_core[^)]*Boost::boost)"));
}

/** "a b" for each room b that room a links, by the build. */
std::set<std::string> linksOfTheBuild() {
  std::set<std::string> out;
  for (const auto& room : fs::directory_iterator(fs::path(SOURCE_DIR) / "src")) {
    const std::string name = room.path().filename();
    std::smatch call;
    const std::string text = contentOf(fs::path("src") / name / "CMakeLists.txt");
    // The panel's library has a shorter name, as RViz's users know it.
    const std::string library_name = name == "rviz_panel" ? "rviz" : name;
    if (!std::regex_search(text, call, std::regex("target_link_libraries\\(poinsot_" + library_name + "([^)]*)\\)")))
      continue;
    const std::string libraries = call[1];
    const std::regex library(R"(poinsot_(\w+))");
    for (std::sregex_iterator it(libraries.begin(), libraries.end(), library), end; it != end; ++it) {
      out.insert(name + " " + (*it)[1].str());
    }
  }
  return out;
}

TEST(Rooms, thePictureShowsWhatTheyLink) {
  std::set<std::string> drawn;
  const std::string picture = contentOf("doc/architecture_rooms.svg");
  const std::regex arrow(R"x(data-links="([^"]+)")x");
  for (std::sregex_iterator it(picture.begin(), picture.end(), arrow), end; it != end; ++it) drawn.insert((*it)[1]);
  EXPECT_EQ(drawn.size(), 7U);
  EXPECT_EQ(drawn, linksOfTheBuild()) << "doc/architecture_rooms.svg and the CMakeLists.txt of the rooms differ";
}

bool isRosLibrary(const std::string& name) {
  return matches(name,
                 R"(^lib(ros|tf|xmlrpcpp|cpp_common|actionlib|message_filters|class_loader|poinsot_(ros|audit)))");
}

TEST(Rooms, coreAndViewLinkNoRosLibrary) {
  for (const std::string library : {CORE_LIBRARY, VIEW_LIBRARY}) {
    const std::vector<std::string> needed = neededBy(library);
    EXPECT_FALSE(needed.empty()) << "readelf said nothing about " << library;  // libc at least
    for (const std::string& name : needed) EXPECT_FALSE(isRosLibrary(name)) << library << " needs " << name;
  }
  for (const std::string& name : neededBy(CORE_LIBRARY)) EXPECT_FALSE(matches(name, "poinsot|yaml")) << name;
}

TEST(Rooms, aRosLibraryWouldBeCaught) {
  for (const char* bad : {"libroscpp.so.4d", "librosconsole.so.3d", "libtf2_ros.so", "libtf2.so.1d", "librostime.so",
                          "libxmlrpcpp.so.4d", "libpoinsot_ros.so"}) {
    EXPECT_TRUE(isRosLibrary(bad)) << bad;
  }
  for (const char* good : {"libc.so.6", "libstdc++.so.6", "libm.so.6", "libpoinsot_core.so", "libquadmath.so.0"}) {
    EXPECT_FALSE(isRosLibrary(good)) << good;
  }
}

}  // namespace
