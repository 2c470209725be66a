#pragma once

#include <rviz/display.h>
#include <rviz/display_group.h>

#include <vector>

namespace poinsot::rviz_panel {

/** The displays of a group, without those of groups in it. */
inline std::vector<rviz::Display*> displaysOf(const rviz::DisplayGroup& group) {
  std::vector<rviz::Display*> out;
  for (int i = 0; i < group.numDisplays(); ++i) out.push_back(group.getDisplayAt(i));
  return out;
}

}  // namespace poinsot::rviz_panel
