#pragma once

#include <poinsot/NodeStatus.h>

#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "status.h"
#include "widgets.h"

namespace poinsot::rviz_panel {

class NodeLink;

/** Chooses the body that is shown, the method that moves it, and its step. */
class MethodChoice : public QWidget {
 public:
  explicit MethodChoice(NodeLink* link);

  void showStatus(const NodeStatus& status);
  QString body() const { return body_->currentText(); }

 private:
  void askMethod(double step);
  void askStep();

  NodeLink* link_;
  QComboBox* body_;
  QComboBox* method_;
  QLabel* step_label_;
  LiveEdit* step_;
  QLabel* words_;
  NodeStatus status_;
  HoldOff hold_off_;
};

}  // namespace poinsot::rviz_panel
