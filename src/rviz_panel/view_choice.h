#pragma once

#include <poinsot/BodyDescription.h>
#include <poinsot/SceneLayout.h>
#include <rviz/config.h>

#include <QGridLayout>
#include <QLabel>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <optional>
#include <string>

#include "hidden_parts.h"
#include "momentum_camera.h"
#include "scene_views.h"

namespace rviz {
class ViewController;
class VisualizationManager;
}  // namespace rviz

namespace poinsot::rviz_panel {

/**
 * Buttons for RViz's saved views. Those that every scene has (scene_views.h) fit the scene that plays and the body that
 * the panel follows, at any size of the window, until the user moves the camera. Riding and Along L leave parts of the
 * picture out (`HiddenParts`). The panel's `View` in a .rviz file is the view that was chosen last.
 */
class ViewChoice : public QWidget {
 public:
  explicit ViewChoice(rviz::VisualizationManager* manager);

  MomentumCamera& camera() { return camera_; }

  void load(const rviz::Config& panel);
  void save(rviz::Config panel) const;

  void showLayout(const SceneLayout& layout);
  /** Of the body that the panel follows. */
  void showDescription(const BodyDescription& description);

  /** Chooses a view by its name; nothing where there is none of that name. */
  void chooseNamed(const QString& view);
  /** Another scene plays: back to the overview. */
  void sceneChanged() { chooseNamed(scene_views::kOverview); }

  /** Shows a button for each view that RViz has saved, and fits the views where the window has another size. */
  void refresh();
  /** Looks from the saved view at that place in RViz's list; nothing where there is none. */
  void take(int index);

 private:
  void take(rviz::ViewController* view);
  void choose(const QString& view);
  void markChosen();
  /** Fits the saved views, and the camera that shows one of them. */
  void fit();
  void fitView(const rviz::Config& view);
  void fitFloor();
  /** Whether the body that the panel follows has a picture in world axes. */
  bool hasPicture() const;
  /** The saved view of that name; null where there is none. */
  rviz::ViewController* saved(const QString& view) const;
  /** Whether RViz's camera is that of the chosen view as it was saved. */
  bool isAsSaved() const;
  /** Whether RViz's camera is as this class has set it. */
  bool isUntouched() const;

  rviz::VisualizationManager* const manager_;
  QLabel* title_;
  QGridLayout* buttons_;
  QStringList names_;
  QString chosen_;
  HiddenParts hidden_;
  MomentumCamera camera_;
  std::optional<SceneLayout> layout_;
  std::string body_, frame_;  ///< that the panel follows
  double aspect_ = 0;         ///< of the picture for which the views were fitted
  QString set_;               ///< RViz's camera, as it was set last
};

}  // namespace poinsot::rviz_panel
