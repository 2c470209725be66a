#pragma once

#include <poinsot/NodeStatus.h>

#include <QElapsedTimer>
#include <QWidget>

#include "time_page.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSlider;
class QToolButton;

namespace poinsot::rviz_panel {

/** Play, pause, step, reset; where t is and where it shall be; how fast it runs. */
class Transport : public QWidget {
  Q_OBJECT

 public:
  explicit Transport(QWidget* parent = nullptr);

  void showStatus(const NodeStatus& status);
  /** t between two statuses. */
  void showTime(double time);

  double span() const;
  bool bothSides() const;
  void setSpan(double span, bool both_sides);

 Q_SIGNALS:
  void pauseAsked(bool paused);
  void stepAsked();
  void resetAsked();
  void speedAsked(double speed);
  void seekAsked(double time);
  /** The user typed what is not a time. */
  void refused(const QString& message);
  void spanChanged();

 private:
  void buildButtons();
  void buildTime();
  void buildSpeed();
  void askPause();
  void askSpeed(double magnitude);
  void seekToSlider();
  void seekToText();
  void newPage();
  void showPage();
  void showPaused(bool paused);
  void showSpeed(double speed);

  QPushButton* play_;
  QPushButton* step_;
  QPushButton* reset_;
  QLineEdit* time_;
  QSlider* time_slider_;
  QLabel* page_from_;
  QLabel* page_to_;
  QComboBox* span_;
  QToolButton* both_sides_;
  QSlider* speed_slider_;
  QLabel* speed_text_;
  QToolButton* backwards_;
  QToolButton* real_time_;

  TimePage page_;
  double now_ = 0;
  double speed_ = 1;
  bool paused_ = false;
  // What the user has just set is not overwritten by a status from before it.
  QElapsedTimer since_pause_;
  QElapsedTimer since_seek_;
  QElapsedTimer since_speed_;
};

}  // namespace poinsot::rviz_panel
