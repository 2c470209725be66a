#pragma once

#include <poinsot/BodyState.h>
#include <poinsot/NodeStatus.h>
#include <rviz/panel.h>

#include <QComboBox>
#include <QTimer>
#include <optional>

#include "widgets.h"

namespace poinsot::rviz_panel {

class Banner;
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
  /** Makes what needs a node, apart from the choice of a method. */
  QWidget* makeControls();
  QWidget* makePage();
  void listen();
  void onStatus(const NodeStatus& status);
  void onState(const BodyState& state);
  void onFound();
  void onLost();
  void setControllable(bool controllable);
  /** Shows the bodies that there are, of which one is read out and plotted. */
  void offer(const QStringList& bodies);
  void takeTypedNode();
  /** Looks from the saved view of that name, if there is one. */
  void refresh();
  /** Forgets what the body did. */
  void clear();

  NodeLink* link_;
  Banner* banner_;
  QWidget* controls_;
  TimeControl* time_;
  QComboBox* body_;
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
