#pragma once

#include <QCheckBox>

namespace rviz {
class VisualizationManager;
}

namespace poinsot::rviz_panel {

/** A box that makes RViz's background light or dark, and shows which it is. */
QCheckBox* makeBackgroundBox(rviz::VisualizationManager* manager);

/** Whether RViz's background is light. */
bool isBackgroundLight(const rviz::VisualizationManager& manager);

}  // namespace poinsot::rviz_panel
