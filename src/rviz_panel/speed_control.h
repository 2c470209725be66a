#pragma once

#include <poinsot/NodeStatus.h>

#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "status.h"

namespace poinsot::rviz_panel {

class NodeLink;

/** Shows and sets how fast t runs, and in which direction. */
class SpeedControl : public QWidget {
 public:
  explicit SpeedControl(NodeLink* link);
  void showStatus(const NodeStatus& status);

 private:
  void ask(double magnitude);
  void showSpeed(double speed);

  NodeLink* link_;
  QSlider* slider_;
  QLabel* text_;
  QToolButton* backwards_;
  double speed_ = 1;
  HoldOff hold_off_;
};

}  // namespace poinsot::rviz_panel
