#pragma once

#include <poinsot/NodeStatus.h>

#include <QElapsedTimer>
#include <QWidget>

class QComboBox;
class QToolButton;

namespace poinsot::rviz_panel {

/** Which scene plays: one of the package's, or a file of one's own. */
class SceneChoice : public QWidget {
  Q_OBJECT

 public:
  explicit SceneChoice(QWidget* parent = nullptr);
  void showStatus(const NodeStatus& status);

 Q_SIGNALS:
  /** A name that the node knows, the path of a file, or nothing: the present scene once more. */
  void sceneAsked(const QString& scene);

 private:
  void open();

  QComboBox* scene_;
  QToolButton* open_;
  QString file_;
  QString present_;
  QElapsedTimer since_asked_;
};

}  // namespace poinsot::rviz_panel
