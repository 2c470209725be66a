#pragma once

#include <poinsot/NodeStatus.h>

#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "status.h"
#include "widgets.h"

namespace poinsot::rviz_panel {

class NodeLink;

/** Chooses the method that moves the body that is shown, and its step. */
class MethodChoice : public QWidget {
 public:
  explicit MethodChoice(NodeLink* link);

  /** Shows what moves a body. */
  void showStatus(const NodeStatus& status, const QString& body);

 private:
  void askMethod(double step);
  void askStep();

  NodeLink* link_;
  QComboBox* method_;
  QLabel* step_label_;
  LiveEdit* step_;
  QLabel* words_;
  QString body_;
  HoldOff hold_off_;
};

}  // namespace poinsot::rviz_panel
