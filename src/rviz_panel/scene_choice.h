#pragma once

#include <poinsot/NodeStatus.h>

#include <QComboBox>
#include <QWidget>

#include "status.h"

namespace poinsot::rviz_panel {

class NodeLink;

/** Chooses the scene that plays: one of the package's, or a file of the user's. */
class SceneChoice : public QWidget {
 public:
  explicit SceneChoice(NodeLink* link);
  void showStatus(const NodeStatus& status);

 private:
  QComboBox* scene_;
  QString file_;
  QString present_;
  HoldOff hold_off_;
};

}  // namespace poinsot::rviz_panel
