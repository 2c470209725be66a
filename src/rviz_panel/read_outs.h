#pragma once

#include <poinsot/BodyState.h>
#include <poinsot/NodeStatus.h>

#include <QGridLayout>
#include <QLabel>
#include <QWidget>

#include "widgets.h"

namespace poinsot::rviz_panel {

/**
 * The figures of one body's motion: energy, momentum, their drift, the true error, flips, cost, regime.
 */
class ReadOuts : public QWidget {
 public:
  ReadOuts();

  void showStatus(const NodeStatus& status, const QString& body);
  void showState(const BodyState& state);
  /** Shows that nothing is known. */
  void clear();

 private:
  void showHeld(const BodyStatus& body);
  QLabel* addTitle(int row, const QString& text, const QString& tip);
  QLabel* addRow(int row, const QString& title, const QString& name, const QString& tip, int columns = 1);
  QLabel* addValue(int row, int column, const QString& name, const QString& tip, int columns = 1);

  QGridLayout* grid_;
  QLabel* energy_;
  QLabel* energy_drift_;
  QLabel* momentum_;
  QLabel* momentum_drift_;
  QLabel* attitude_error_;
  QLabel* flips_title_;
  QLabel* flips_;
  QLabel* next_flip_;
  QLabel* cost_;
  QLabel* regime_title_;
  QLabel* regime_;
  bool held_ = false;  ///< the spin is being dragged: energy and momentum are those of the motion that would begin
};

}  // namespace poinsot::rviz_panel
