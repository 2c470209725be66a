#include "view_file.h"

#include <ros/package.h>
#include <rviz/yaml_config_reader.h>

#include <QFileInfo>

#include "displays.h"

namespace poinsot::rviz_panel::view_file {
namespace {

QString valueOf(const rviz::Config& map, const char* key) {
  QString value;
  map.mapGetString(key, &value);
  return value;
}

}  // namespace

std::optional<rviz::Config> read(const QString& scene) {
  const QString file = QString::fromStdString(ros::package::getPath("poinsot")) + "/rviz/" + scene + ".rviz";
  if (scene.isEmpty() || scene.contains('/') || !QFileInfo(file).isFile()) return std::nullopt;
  rviz::Config config;
  rviz::YamlConfigReader reader;
  reader.readFile(config, file);
  if (reader.error() || !viewsOf(config).isValid()) return std::nullopt;
  return config;
}

rviz::Config viewsOf(const rviz::Config& file) {
  return file.mapGetChild("Visualization Manager").mapGetChild("Views");
}

std::optional<rviz::Config> panelOf(const rviz::Config& file) {
  const rviz::Config panels = file.mapGetChild("Panels");
  for (int i = 0; i < panels.listLength(); ++i) {
    if (valueOf(panels.listChildAt(i), "Class") == "poinsot/Panel") return panels.listChildAt(i);
  }
  return std::nullopt;
}

rviz::Config takenOf(const rviz::Config& display) {
  rviz::Config taken;
  for (const char* key : {"Enabled", "Namespaces", "Cell Size", "Plane Cell Count", "Offset"}) {
    const rviz::Config value = display.mapGetChild(key);
    if (value.isValid()) taken.mapMakeChild(key).copy(value);
  }
  return taken;
}

void fitDisplays(const rviz::DisplayGroup& displays, const rviz::Config& file) {
  const rviz::Config wanted = file.mapGetChild("Visualization Manager").mapGetChild("Displays");
  for (int k = 0; k < wanted.listLength(); ++k) {
    const rviz::Config one = wanted.listChildAt(k);
    for (rviz::Display* const display : displaysOf(displays)) {
      if (display->getName() == valueOf(one, "Name") && display->getClassId() == valueOf(one, "Class")) {
        display->load(takenOf(one));
      }
    }
  }
}

}  // namespace poinsot::rviz_panel::view_file
