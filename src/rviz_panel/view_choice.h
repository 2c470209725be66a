#pragma once

#include <poinsot/BodyDescription.h>
#include <poinsot/BodyState.h>
#include <rviz/config.h>

#include <QHash>
#include <QPointer>
#include <QStringList>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <optional>

class QCheckBox;
class QGridLayout;
class QLabel;

namespace rviz {
class ColorProperty;
class Display;
class ViewController;
class VisualizationManager;
}  // namespace rviz

namespace poinsot::rviz_panel {

/**
 * How RViz looks at it: the saved views of the present scene, and a dark or a light background.
 *
 * A view may leave out what would pass before the camera. In a .rviz file the panel's `Hidden` says it, for each view
 * by the name of a display: a list of namespaces of markers, or `true` for the whole display. What the user has
 * switched off stays off when such a view is left; where the file was saved in such a view, `Switched Off` says what.
 * A view that `Down L` names looks along the present L of the body that stands there: when it is chosen, and when the
 * motion begins anew with another L; else it looks as it was saved. The panel's `View` is the view that was chosen
 * last.
 */
class ViewChoice : public QWidget {
  Q_OBJECT

 public:
  explicit ViewChoice(QWidget* parent = nullptr);
  void setManager(rviz::VisualizationManager* manager);

  /** Dark or light; for whoever has room for it. */
  QWidget* light() const;

  // Of the body that the panel follows.
  void showState(const BodyState& state);
  void showDescription(const BodyDescription& description);

  void load(const rviz::Config& panel);
  void save(rviz::Config panel) const;

  /**
   * Takes the views from rviz/<scene>.rviz of this package; where there is none, all stays as it is. Displays of the
   * same name and kind are shown or not as in that file, with its hidden namespaces and its floor's place and size; no
   * more.
   */
  void loadViewsOf(const QString& scene);

 private:
  void listViews();
  void take(int index);
  void choose(const QString& view);
  void forEachLeftOut(const QString& view, const std::function<void(rviz::Display&, const rviz::Config&)>& act);
  void setShown(const QString& view, bool shown);
  void rememberShown(const QString& view);
  void lookDownMomentum();
  void fitDisplays(const rviz::Config& file);
  void markChosen();
  rviz::ColorProperty* background() const;
  void showBackground();

  rviz::VisualizationManager* manager_ = nullptr;
  QLabel* title_;
  QGridLayout* buttons_;
  QCheckBox* light_;
  QStringList names_;
  QString chosen_;
  rviz::Config hidden_;
  rviz::Config down_momentum_;
  std::optional<BodyState> state_;
  BodyDescription description_;
  QPointer<rviz::ViewController> camera_;  ///< that of the chosen view, for as long as it is the one in use
  QHash<QString, bool> was_shown_;         ///< "display", or "display/namespace": before a view left it out
  QTimer timer_;
};

}  // namespace poinsot::rviz_panel
