#pragma once

#include <QStringList>
#include <QTimer>
#include <QWidget>

class QCheckBox;
class QGridLayout;
class QLabel;

namespace rviz {
class ColorProperty;
class VisualizationManager;
}  // namespace rviz

namespace poinsot::rviz_panel {

/** How RViz looks at it: the saved views of the present scene, and a dark or a light background. */
class ViewChoice : public QWidget {
  Q_OBJECT

 public:
  explicit ViewChoice(QWidget* parent = nullptr);
  void setManager(rviz::VisualizationManager* manager);

  /** Dark or light; for whoever has room for it. */
  QWidget* light() const;

  /** Takes the views from rviz/<scene>.rviz of this package; where there is none, all stays as it is. */
  void loadViewsOf(const QString& scene);

 private:
  void listViews();
  void take(int index);
  rviz::ColorProperty* background() const;
  void showBackground();

  rviz::VisualizationManager* manager_ = nullptr;
  QLabel* title_;
  QGridLayout* buttons_;
  QCheckBox* light_;
  QStringList names_;
  QTimer timer_;
};

}  // namespace poinsot::rviz_panel
