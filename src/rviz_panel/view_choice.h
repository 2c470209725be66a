#pragma once

#include <rviz/config.h>

#include <QGridLayout>
#include <QLabel>
#include <QString>
#include <QStringList>
#include <QWidget>

#include "hidden_parts.h"
#include "momentum_camera.h"

namespace rviz {
class VisualizationManager;
}

namespace poinsot::rviz_panel {

/**
 * Buttons for RViz's saved views. A view may leave parts of the picture out (`HiddenParts`) and look along L
 * (`MomentumCamera`). The panel's `View` in a .rviz file is the view that was chosen last.
 */
class ViewChoice : public QWidget {
 public:
  explicit ViewChoice(rviz::VisualizationManager* manager);

  MomentumCamera& camera() { return camera_; }

  void load(const rviz::Config& panel);
  void save(rviz::Config panel) const;

  /**
   * Takes the views from rviz/<scene>.rviz of this package; where there is none, all stays as it is. Displays of the
   * same name and kind are shown or not as in that file, with its hidden namespaces and its floor's place and size; no
   * more.
   */
  void loadViewsOf(const QString& scene);

  /** Shows a button for each view that RViz has saved. */
  void refresh();
  /** Looks from the saved view at that place in RViz's list; nothing where there is none. */
  void take(int index);

 private:
  void choose(const QString& view);
  void markChosen();

  rviz::VisualizationManager* const manager_;
  QLabel* title_;
  QGridLayout* buttons_;
  QStringList names_;
  QString chosen_;
  HiddenParts hidden_;
  MomentumCamera camera_;
};

}  // namespace poinsot::rviz_panel
