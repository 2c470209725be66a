#pragma once

#include <poinsot/NodeStatus.h>

#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "scene_groups.h"
#include "status.h"

namespace poinsot::rviz_panel {

class NodeLink;

/** Chooses the scene that plays: one of the package's, in groups, or a file of the user's. */
class SceneChoice : public QWidget {
 public:
  /** @param beside another widget, at the end of the row. */
  SceneChoice(NodeLink* link, QWidget* beside);
  void showStatus(const NodeStatus& status);

 private:
  void showScenes(const QStringList& scenes);

  QComboBox* scene_;
  QLabel* shows_;  ///< what is to be seen in the present one
  QVector<SceneGroup> groups_;
  QString file_;
  QString present_;
  HoldOff hold_off_;
};

}  // namespace poinsot::rviz_panel
