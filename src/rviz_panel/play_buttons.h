#pragma once

#include <poinsot/NodeStatus.h>

#include <QPushButton>
#include <QWidget>

#include "status.h"

namespace poinsot::rviz_panel {

class NodeLink;

/** The buttons for reset, play or pause, and step. */
class PlayButtons : public QWidget {
 public:
  explicit PlayButtons(NodeLink* link);
  void showStatus(const NodeStatus& status);

 private:
  void showPaused(bool paused);

  QPushButton* play_;
  QPushButton* step_;
  bool paused_ = false;
  HoldOff hold_off_;
};

}  // namespace poinsot::rviz_panel
