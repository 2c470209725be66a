#pragma once

#include <poinsot/BodyState.h>
#include <poinsot/NodeStatus.h>

#include <QWidget>
#include <optional>
#include <string>

class QGridLayout;
class QLabel;

namespace poinsot::rviz_panel {

class ElidedLabel;

/** What one body's motion amounts to, in figures: energy, momentum, their drift, the true error, flips, cost, regime.
 */
class ReadOuts : public QWidget {
  Q_OBJECT

 public:
  explicit ReadOuts(QWidget* parent = nullptr);

  void showStatus(const NodeStatus& status, const QString& body);
  void showState(const BodyState& state);
  /** Nothing is known. */
  void clear();

 private:
  QLabel* addRow(const QString& title, const QString& name, const QString& tip);

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
  ElidedLabel* regime_;
};

}  // namespace poinsot::rviz_panel
