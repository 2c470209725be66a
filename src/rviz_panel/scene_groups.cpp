#include "scene_groups.h"

#include <QSet>

#include "data_file.h"

namespace poinsot::rviz_panel {
namespace {

constexpr int kMostGroups = 50;
constexpr int kMostScenes = 500;  // of a group
constexpr int kLongest = 80;      // letters
const char* const kGroupsSource = "panel/scenes.yaml";

SceneGroup groupOf(const rviz::Config& entry, const QString& place) {
  SceneGroup out;
  out.title = data_file::textOf(entry, "group", place, kLongest);
  const rviz::Config scenes = entry.mapGetChild("scenes");
  const int count = scenes.listLength();
  if (count < 1 || count > kMostScenes) {
    throw data_file::Error(place, QString("1 to %1 scenes").arg(kMostScenes), QString::number(count));
  }
  for (int i = 0; i < count; ++i) {
    const QString one = place + QString(", scene %1").arg(i + 1);
    out.scenes.push_back({data_file::textOf(scenes.listChildAt(i), "name", one, kLongest),
                          data_file::textOf(scenes.listChildAt(i), "shows", one, kLongest)});
  }
  return out;
}

}  // namespace

QVector<SceneGroup> sceneGroups(const QString& text) {
  const rviz::Config list = data_file::listFrom(text, kGroupsSource, kMostGroups);
  QVector<SceneGroup> out;
  QSet<QString> names;
  for (int i = 0; i < list.listLength(); ++i) {
    const QString place = QString("%1: group %2").arg(kGroupsSource).arg(i + 1);
    out.push_back(groupOf(list.listChildAt(i), place));
    for (const SceneEntry& scene : out.back().scenes) {
      if (names.contains(scene.name)) throw data_file::Error(place, "each scene once", scene.name + " again");
      names.insert(scene.name);
    }
  }
  return out;
}

Choices groupedChoices(const QVector<SceneGroup>& groups, const QStringList& scenes) {
  Choices out;
  QStringList left = scenes;
  for (const SceneGroup& group : groups) {
    Choices lines;
    for (const SceneEntry& scene : group.scenes) {
      if (left.removeAll(scene.name) > 0) lines.push_back({scene.name, scene.shows});
    }
    if (!lines.isEmpty()) out << Choices{{group.title, {}, true}} << lines;
  }
  if (!out.isEmpty() && !left.isEmpty()) out.push_back({"others", {}, true});
  return out << plainChoices(left);
}

}  // namespace poinsot::rviz_panel
