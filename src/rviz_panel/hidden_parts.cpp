#include "hidden_parts.h"

#include <QStringList>

#include "displays.h"

namespace poinsot::rviz_panel {

void HiddenParts::load(const rviz::Config& panel) {
  hidden_ = panel.mapGetChild("Hidden");
  was_shown_.clear();
  const rviz::Config off = panel.mapGetChild("Switched Off");
  for (int i = 0; i < off.listLength(); ++i) was_shown_[off.listChildAt(i).getValue().toString()] = false;
}

void HiddenParts::set(const rviz::Config& hidden, const rviz::DisplayGroup& displays, const QString& view) {
  bringBack(displays, view);
  rviz::Config merged;
  merged.copy(hidden);
  for (rviz::Config::MapIterator it = hidden_.mapIterator(); it.isValid(); it.advance()) {
    if (!hidden.mapGetChild(it.currentKey()).isValid()) merged.mapMakeChild(it.currentKey()).copy(it.currentChild());
  }
  hidden_ = merged;
  remember(displays, view);
  hide(displays, view);
}

void HiddenParts::save(rviz::Config panel, const QString& view) const {
  if (hidden_.isValid()) panel.mapMakeChild("Hidden").copy(hidden_);
  QStringList off = was_shown_.keys(false);
  if (!hidden_.mapGetChild(view).isValid() || off.isEmpty()) return;
  off.sort();
  rviz::Config list = panel.mapMakeChild("Switched Off");
  for (const QString& what : off) list.listAppendNew().setValue(what);
}

void HiddenParts::forEach(const rviz::DisplayGroup& displays, const QString& view, const Act& act) const {
  for (rviz::Display* const display : displaysOf(displays)) {
    const rviz::Config what = hidden_.mapGetChild(view).mapGetChild(display->getName());
    if (what.isValid()) act(*display, what);
  }
}

void HiddenParts::remember(const rviz::DisplayGroup& displays, const QString& view) {
  forEach(displays, view, [this](rviz::Display& display, const rviz::Config& what) {
    const QString name = display.getName();
    if (what.getType() == rviz::Config::Value) {
      was_shown_[name] = display.isEnabled();
    } else if (what.getType() == rviz::Config::List) {
      // Those that are not listed have not come since the display was switched on: as they were before.
      const rviz::Property* const listed = display.subProp("Namespaces");
      for (int k = 0; k < listed->numChildren(); ++k) {
        was_shown_[name + '/' + listed->childAt(k)->getName()] = listed->childAt(k)->getValue().toBool();
      }
    }
  });
}

void HiddenParts::show(const rviz::DisplayGroup& displays, const QString& view, bool shown) const {
  forEach(displays, view, [this, shown](rviz::Display& display, const rviz::Config& what) {
    const QString name = display.getName();
    if (what.getType() == rviz::Config::Value) {
      display.setEnabled(shown && was_shown_.value(name, true));
    } else if (what.getType() == rviz::Config::List) {
      rviz::Config settings;
      rviz::Config namespaces = settings.mapMakeChild("Namespaces");
      for (int k = 0; k < what.listLength(); ++k) {
        const QString ns = what.listChildAt(k).getValue().toString();
        namespaces.mapSetValue(ns, shown && was_shown_.value(name + '/' + ns, true));
      }
      // RViz keeps nothing of a namespace that is hidden, and what stands still is sent only to new subscribers:
      // switching the display off and on subscribes anew.
      const bool enabled = display.isEnabled();
      display.setEnabled(false);
      display.load(settings);
      display.setEnabled(enabled);
    }
  });
}

}  // namespace poinsot::rviz_panel
