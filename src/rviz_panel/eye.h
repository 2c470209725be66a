#pragma once

#include <array>
#include <optional>

namespace rviz {
class VisualizationManager;
}

namespace poinsot::rviz_panel {

/** Where RViz's camera is, in the frame "world" [m]; nothing where that cannot be told. */
std::optional<std::array<double, 3>> eyeInWorld(rviz::VisualizationManager& manager);

}  // namespace poinsot::rviz_panel
