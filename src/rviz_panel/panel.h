#pragma once

#include <poinsot/BodyState.h>
#include <poinsot/NodeStatus.h>
#include <rviz/panel.h>

#include <QLabel>
#include <QTimer>
#include <optional>

#include "widgets.h"

namespace poinsot::rviz_panel {

class MethodChoice;
class NodeLink;
class Notice;
class Plots;
class ReadOuts;
class ResetGuard;
class TimeControl;
class ViewChoice;

/** Controls one Poinsot node from within RViz, and shows what its bodies do. See doc/panel.md. */
class Panel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit Panel(QWidget* parent = nullptr);

  void onInitialize() override;
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;
  QSize sizeHint() const override;

 private:
  /** Makes all that needs a node. */
  QWidget* makeControls();
  QWidget* makePage();
  void listen();
  void onStatus(const NodeStatus& status);
  void onState(const BodyState& state);
  void onLost();
  void takeTypedNode();
  void refresh();
  /** Forgets what the body did. */
  void clear();

  NodeLink* link_;
  QLabel* banner_;
  QWidget* controls_;
  TimeControl* time_;
  MethodChoice* method_;
  ReadOuts* read_outs_;
  Plots* plots_;
  ViewChoice* views_;
  QLineEdit* node_;
  Notice* notice_;
  ResetGuard* reset_guard_;
  QTimer timer_;
  std::optional<BodyState> newest_;
  std::optional<QString> scene_;  ///< of the last status
};

}  // namespace poinsot::rviz_panel
