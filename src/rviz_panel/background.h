#pragma once

#include <rviz/properties/color_property.h>

#include <QCheckBox>

namespace rviz {
class VisualizationManager;
}

namespace poinsot::rviz_panel {

/** Makes RViz's background light or dark, and shows which it is. */
class Background : public QCheckBox {
 public:
  explicit Background(rviz::VisualizationManager* manager);

 private:
  void showColour();

  rviz::ColorProperty* const colour_;  ///< null where RViz has none
};

}  // namespace poinsot::rviz_panel
