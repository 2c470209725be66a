#pragma once

#include <poinsot/NodeStatus.h>

#include <QElapsedTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;

namespace poinsot::rviz_panel {

/** Which body is looked at, which method moves it, and at which step. */
class MethodChoice : public QWidget {
  Q_OBJECT

 public:
  explicit MethodChoice(QWidget* parent = nullptr);

  void showStatus(const NodeStatus& status);
  QString body() const;

 Q_SIGNALS:
  void bodyChanged(const QString& body);
  /** `step` in seconds; 0: whatever suits. */
  void methodAsked(const QString& body, const QString& method, double step);
  /** The user typed what is not a step. */
  void refused(const QString& message);

 private:
  void askMethod();
  void askStep();

  QComboBox* body_;
  QComboBox* method_;
  QLabel* step_label_;
  QLineEdit* step_;
  NodeStatus status_;
  QElapsedTimer since_asked_;
};

}  // namespace poinsot::rviz_panel
