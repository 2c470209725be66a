#pragma once

#include <poinsot/BodyState.h>
#include <poinsot/NodeStatus.h>
#include <rviz/config.h>

#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QWidget>
#include <cstdint>

#include "asked_time.h"
#include "status.h"
#include "time_page.h"
#include "widgets.h"

namespace poinsot::rviz_panel {

class NodeLink;

/** Shows t and seeks to another: typed, or on a slider that spans a page of time. */
class TimeControl : public QWidget {
  Q_OBJECT

 public:
  explicit TimeControl(NodeLink* link);

  void showStatus(const NodeStatus& status);
  void showState(const BodyState& state);

  void load(const rviz::Config& panel);
  void save(rviz::Config panel) const;

 Q_SIGNALS:
  void spanChanged();

 private:
  /** Shows the t of a message, unless another is asked for. @param seeking whether the node is on its way to another.
   */
  void showTime(double time, std::uint32_t segment, bool seeking);
  /** Shows t in the line, on the slider and on the page. */
  void display(double time);
  void showStart();
  void seekToSlider();
  void seekToText();
  void newPage();
  void showPage();
  void showOnSlider();

  NodeLink* link_;
  LiveEdit* time_;
  QComboBox* span_;
  QToolButton* both_sides_;
  QSlider* slider_;
  QLabel* from_;
  QLabel* to_;
  TimePage page_;
  double now_ = 0;
  HoldOff hold_off_;
  AskedTime asked_;
  QElapsedTimer clock_;
};

}  // namespace poinsot::rviz_panel
