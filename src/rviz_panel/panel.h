#pragma once

#include <rviz/panel.h>

#include <QElapsedTimer>
#include <QTimer>
#include <optional>

#include "node_link.h"
#include "stamp_watch.h"

class QFrame;
class QLabel;
class QLineEdit;

namespace poinsot::rviz_panel {

class ElidedLabel;
class MethodChoice;
class Plots;
class ReadOuts;
class SceneChoice;
class Transport;
class ViewChoice;
class Viewpoint;

/** Leads one Poinsot node from within RViz, and reads out what its bodies do. See doc/panel.md. */
class Panel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit Panel(QWidget* parent = nullptr);

  void onInitialize() override;
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;
  QSize sizeHint() const override;

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void build();
  void wire();
  void onStatus(const NodeStatus& status);
  void onState(const BodyState& state);
  void onLost();
  void refresh();
  /** Follows the state of the chosen body, while anybody can see it. */
  void follow();
  void say(const QString& message, bool trouble);
  void showNotice();
  void showNode();

  NodeLink* link_;
  Viewpoint* viewpoint_ = nullptr;
  QLabel* banner_;
  SceneChoice* scene_;
  ViewChoice* views_;
  QWidget* controls_;  ///< all that needs a node
  Transport* transport_;
  MethodChoice* method_;
  ReadOuts* read_outs_;
  Plots* plots_;
  QLineEdit* node_;
  QLabel* notice_;

  QTimer timer_;
  std::optional<BodyState> newest_;
  std::optional<QString> scene_name_;  ///< of the last status
  QString busy_, refused_;             ///< of the last status
  QString said_;                       ///< what a service answered
  bool said_trouble_ = false;
  StampWatch stamps_;
  QElapsedTimer since_said_;
  QElapsedTimer since_idle_;  ///< since the node had nothing to work out
};

}  // namespace poinsot::rviz_panel
