// The groups in which the panel lists the scenes.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "data_file.h"
#include "scene_groups.h"

namespace {

using namespace poinsot::rviz_panel;

QString textOf(const std::string& file) {
  std::ifstream in(std::string(SOURCE_DIR) + "/" + file);
  return QString::fromStdString(std::string(std::istreambuf_iterator<char>(in), {}));
}

std::string refusalOf(const char* text) {
  try {
    sceneGroups(text);
  } catch (const data_file::Error& error) {
    return error.what();
  }
  return "";
}

TEST(SceneGroups, everySceneIsInOneGroup) {
  std::set<std::string> listed;
  for (const SceneGroup& group : sceneGroups(textOf("panel/scenes.yaml"))) {
    for (const SceneEntry& scene : group.scenes) {
      EXPECT_TRUE(listed.insert(scene.name.toStdString()).second) << scene.name.toStdString() << " is listed twice";
    }
  }
  std::set<std::string> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(SOURCE_DIR) + "/scenes")) {
    scenes.insert(entry.path().stem().string());
  }
  EXPECT_EQ(listed, scenes);
}

TEST(SceneGroups, areThoseOfTheGallery) {
  // "| the flip | [dzhanibekov](#dzhanibekov) · [t_handle](#t_handle) |"
  const std::regex row("\\| ([^|]+) \\| (\\[.*) \\|"), link("\\[(\\w+)\\]");
  std::vector<std::pair<std::string, std::vector<std::string>>> gallery, panel;
  std::ifstream in(std::string(SOURCE_DIR) + "/doc/gallery.md");
  for (std::string line; std::getline(in, line);) {
    std::smatch cells;
    if (!std::regex_match(line, cells, row)) continue;
    const std::string names = cells[2];
    gallery.push_back({cells[1], {}});
    for (std::sregex_iterator i(names.begin(), names.end(), link); i != std::sregex_iterator(); ++i) {
      gallery.back().second.push_back((*i)[1]);
    }
  }
  for (const SceneGroup& group : sceneGroups(textOf("panel/scenes.yaml"))) {
    panel.push_back({group.title.toStdString(), {}});
    for (const SceneEntry& scene : group.scenes) panel.back().second.push_back(scene.name.toStdString());
  }
  EXPECT_EQ(panel, gallery);
}

TEST(SceneGroups, whatIsWrongIsRefused) {
  EXPECT_EQ(refusalOf("- group: a\n  scenes: [{name: b, shows: c}]\n"), "");
  EXPECT_NE(refusalOf("a: ]").find("panel/scenes.yaml: expected YAML, got"), std::string::npos) << refusalOf("a: ]");
  EXPECT_EQ(refusalOf("a: b"), "panel/scenes.yaml: expected a list of 1 to 50 entries, got something else");
  EXPECT_EQ(refusalOf("- scenes: [{name: b, shows: c}]"),
            "panel/scenes.yaml: group 1: expected a text of 1 to 80 letters under group, got none");
  EXPECT_EQ(refusalOf("- group: a"), "panel/scenes.yaml: group 1: expected 1 to 500 scenes, got 0");
  EXPECT_EQ(refusalOf("- {group: a, scenes: [{name: b}]}"),
            "panel/scenes.yaml: group 1, scene 1: expected a text of 1 to 80 letters under shows, got none");
  EXPECT_EQ(refusalOf("- {group: a, scenes: [{name: b, shows: c}, {name: b, shows: d}]}"),
            "panel/scenes.yaml: group 1: expected each scene once, got b again");
}

TEST(GroupedChoices, listWhatTheNodeHas) {
  const auto groups = sceneGroups(
      "- {group: one, scenes: [{name: b, shows: words}, {name: a, shows: more}]}\n"
      "- {group: two, scenes: [{name: c, shows: nothing}]}\n");
  const Choices expected = {{"one", {}, true}, {"a", "more"}, {"others", {}, true}, {"x", {}}};
  EXPECT_EQ(groupedChoices(groups, {"a", "x"}), expected);
  EXPECT_EQ(groupedChoices({}, {"a", "x"}), plainChoices({"a", "x"}));
}

}  // namespace
