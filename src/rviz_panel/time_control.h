#pragma once

#include <rviz/config.h>

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

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

  void showTime(double time);

  void load(const rviz::Config& panel);
  void save(rviz::Config panel) const;

 Q_SIGNALS:
  void spanChanged();

 private:
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
};

}  // namespace poinsot::rviz_panel
