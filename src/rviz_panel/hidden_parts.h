#pragma once

#include <rviz/config.h>

#include <QHash>
#include <QString>
#include <functional>

namespace rviz {
class Display;
class DisplayGroup;
}  // namespace rviz

namespace poinsot::rviz_panel {

/**
 * What views leave out of the picture because it would pass before the camera.
 *
 * In a .rviz file the panel's `Hidden` says it, for each view by the name of a display: a list of namespaces of
 * markers, or `true` for the whole display. What the user has switched off stays off when such a view is left; where
 * the file was saved in such a view, `Switched Off` says what.
 */
class HiddenParts {
 public:
  void load(const rviz::Config& panel);
  /** Takes another list of what the views that it names leave out; the present view leaves that out at once. */
  void set(const rviz::Config& hidden, const rviz::DisplayGroup& displays, const QString& view);
  /** @param view the present one */
  void save(rviz::Config panel, const QString& view) const;

  /** Remembers what of the view's parts is shown. */
  void remember(const rviz::DisplayGroup& displays, const QString& view);
  /** Hides what the view leaves out. */
  void hide(const rviz::DisplayGroup& displays, const QString& view) { show(displays, view, false); }
  /** Shows it again, but for what had been switched off before. */
  void bringBack(const rviz::DisplayGroup& displays, const QString& view) { show(displays, view, true); }

 private:
  using Act = std::function<void(rviz::Display& display, const rviz::Config& what)>;
  void forEach(const rviz::DisplayGroup& displays, const QString& view, const Act& act) const;
  void show(const rviz::DisplayGroup& displays, const QString& view, bool shown) const;

  rviz::Config hidden_;
  QHash<QString, bool> was_shown_;  ///< "display", or "display/namespace": before a view left it out
};

}  // namespace poinsot::rviz_panel
