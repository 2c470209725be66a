#pragma once

#include "poinsot/NodeStatus.h"

namespace poinsot::rviz_panel {

inline constexpr int kHoldOff = 700;  // ms: for so long what the user has just chosen is not overwritten

/** Whether another scene, method or spin is being worked out; a seek, which a status calls busy too, changes none. */
inline bool changing(const NodeStatus& status) {
  return !status.busy.empty() && status.busy != "seek";
}

}  // namespace poinsot::rviz_panel
