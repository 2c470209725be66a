#include "view_choice.h"

#include <ros/package.h>
#include <rviz/display.h>
#include <rviz/display_group.h>
#include <rviz/properties/color_property.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>
#include <rviz/window_manager_interface.h>
#include <rviz/yaml_config_reader.h>
#include <Eigen/Core>

#include <QCheckBox>
#include <QCoreApplication>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "colours.h"
#include "widgets.h"

namespace poinsot::rviz_panel {
namespace {

constexpr int kLookEvery = 300;  // ms
constexpr int kColumns = 3;
constexpr double kUpright = 0.12;  // rad: an L that is so near the vertical is looked down from above, not turned round
constexpr double kSameWay = 0.005;        // rad
constexpr double kBeginning = 0.2;        // s
constexpr double kLeastMomentum = 0.005;  // m: what is drawn shorter points nowhere

Eigen::Vector3d momentumOf(const BodyState& state) {
  return {state.momentum_world.x, state.momentum_world.y, state.momentum_world.z};
}

/**
 * RViz sends its list of views calls with bare pointers to properties of a new one; they are to have arrived before
 * another one takes its place.
 */
void settleProperties() {
  QCoreApplication::sendPostedEvents(nullptr, QEvent::MetaCall);
}

}  // namespace

ViewChoice::ViewChoice(QWidget* parent) : QWidget(parent) {
  auto* const layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(4);
  layout->setVerticalSpacing(2);
  title_ = new QLabel("view");
  buttons_ = new QGridLayout;
  buttons_->setSpacing(4);
  light_ = new QCheckBox("&Light background");
  describe(light_, "light_background", "For paper and bright rooms.");
  layout->addWidget(title_, 0, 0, Qt::AlignTop);
  layout->addLayout(buttons_, 0, 1);
  layout->setColumnStretch(1, 1);
  title_->hide();

  connect(light_, &QCheckBox::clicked, this, [this](bool on) {
    rviz::ColorProperty* const colour = background();
    if (colour) colour->setColor(on ? colours::kLightBackground : colours::kDarkBackground);
  });
  connect(&timer_, &QTimer::timeout, this, &ViewChoice::listViews);
}

void ViewChoice::setManager(rviz::VisualizationManager* manager) {
  manager_ = manager;
  rviz::ColorProperty* const colour = background();
  if (colour) connect(colour, &rviz::Property::changed, this, &ViewChoice::showBackground);
  showBackground();
  timer_.start(kLookEvery);
}

QWidget* ViewChoice::light() const {
  return light_;
}

rviz::ColorProperty* ViewChoice::background() const {
  rviz::Property* const root = manager_->getRootDisplayGroup();
  return dynamic_cast<rviz::ColorProperty*>(root->subProp("Global Options")->subProp("Background Color"));
}

void ViewChoice::showBackground() {
  const rviz::ColorProperty* const colour = background();
  const QSignalBlocker quiet(light_);
  light_->setChecked(colour && colour->getColor().lightnessF() > 0.5);
}

void ViewChoice::listViews() {
  rviz::ViewManager* const views = manager_->getViewManager();
  QStringList names;
  for (int i = 0; i < views->getNumViews(); ++i) names << views->getViewAt(i)->getName();
  if (names == names_) return;
  names_ = names;
  while (QLayoutItem* const item = buttons_->takeAt(0)) {
    item->widget()->deleteLater();
    delete item;
  }
  for (int i = 0; i < names.size(); ++i) {
    auto* const button = new QPushButton(names[i]);
    describe(button, QString("view_%1").arg(i), "Look from there: “" + names[i] + "”.");
    button->setMinimumWidth(20);
    button->setCheckable(true);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    connect(button, &QPushButton::clicked, this, [this, i] { take(i); });
    buttons_->addWidget(button, i / kColumns, i % kColumns);
  }
  title_->setVisible(!names.isEmpty());
  markChosen();
}

void ViewChoice::take(int index) {
  rviz::ViewManager* const views = manager_->getViewManager();
  if (index >= views->getNumViews()) return;
  settleProperties();
  views->setCurrentFrom(views->getViewAt(index));
  camera_ = views->getCurrent();
  choose(views->getViewAt(index)->getName());
  lookDownMomentum();
}

void ViewChoice::showDescription(const BodyDescription& description) {
  description_ = description;
}

void ViewChoice::showState(const BodyState& state) {
  const bool first = !state_ || state_->body != state.body;
  // A seek begins a segment as well, and under torques L is another one there.
  const bool begins = first || (state_->segment != state.segment &&
                                (!std::isnan(state.attitude_error) || std::abs(state.time) < kBeginning));
  const bool turned =
      first ||
      (begins && (momentumOf(state).stableNormalized() - momentumOf(*state_).stableNormalized()).norm() > kSameWay);
  state_ = state;
  if (turned) lookDownMomentum();
}

void ViewChoice::lookDownMomentum() {
  QString body;
  if (!manager_ || !state_ || !down_momentum_.mapGetString(chosen_, &body) ||
      body != QString::fromStdString(state_->body)) {
    return;
  }
  // Not one that was chosen elsewhere, such as in the dock Views.
  rviz::ViewController* const camera = manager_->getViewManager()->getCurrent();
  if (!camera || camera != camera_ || camera->getClassId() != "rviz/Orbit") return;
  const double drawn = description_.body == state_->body ? description_.metres_per_angular_momentum : 1;
  const Eigen::Vector3d l = momentumOf(*state_).stableNormalized();
  if (l.isZero(0) || drawn * momentumOf(*state_).stableNorm() < kLeastMomentum) return;
  const bool upright = std::hypot(l.x(), l.y()) < kUpright;
  const double pitch = upright ? std::copysign(M_PI_2, l.z()) : std::asin(std::clamp(l.z(), -1.0, 1.0));
  camera->subProp("Pitch")->setValue(static_cast<float>(pitch));
  camera->subProp("Yaw")->setValue(static_cast<float>(upright ? 0 : std::atan2(l.y(), l.x())));
}

void ViewChoice::choose(const QString& view) {
  if (view != chosen_) {
    setShown(chosen_, true);
    rememberShown(view);
    setShown(view, false);
    chosen_ = view;
  }
  markChosen();
}

void ViewChoice::markChosen() {
  for (int i = 0; i < buttons_->count(); ++i) {
    if (auto* const button = qobject_cast<QPushButton*>(buttons_->itemAt(i)->widget())) {
      button->setChecked(button->text() == chosen_);
    }
  }
}

void ViewChoice::forEachLeftOut(const QString& view,
                                const std::function<void(rviz::Display&, const rviz::Config&)>& act) {
  rviz::DisplayGroup* const displays = manager_->getRootDisplayGroup();
  for (int i = 0; i < displays->numDisplays(); ++i) {
    rviz::Display* const display = displays->getDisplayAt(i);
    const rviz::Config what = hidden_.mapGetChild(view).mapGetChild(display->getName());
    if (what.isValid()) act(*display, what);
  }
}

void ViewChoice::rememberShown(const QString& view) {
  forEachLeftOut(view, [this](rviz::Display& display, const rviz::Config& what) {
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

void ViewChoice::setShown(const QString& view, bool shown) {
  forEachLeftOut(view, [this, shown](rviz::Display& display, const rviz::Config& what) {
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
      // RViz keeps nothing of a namespace that is hidden: what stands still is sent only to a newcomer.
      const bool enabled = display.isEnabled();
      display.setEnabled(false);
      display.load(settings);
      display.setEnabled(enabled);
    }
  });
}

void ViewChoice::load(const rviz::Config& panel) {
  hidden_ = panel.mapGetChild("Hidden");
  down_momentum_ = panel.mapGetChild("Down L");
  was_shown_.clear();
  const rviz::Config off = panel.mapGetChild("Switched Off");
  for (int i = 0; i < off.listLength(); ++i) was_shown_[off.listChildAt(i).getValue().toString()] = false;
  camera_ = manager_->getViewManager()->getCurrent();
  // What is hidden now has been hidden by this view, as the file was saved, and not by the user.
  chosen_.clear();
  panel.mapGetString("View", &chosen_);
  setShown(chosen_, false);
  markChosen();
}

void ViewChoice::save(rviz::Config panel) const {
  if (!chosen_.isEmpty()) panel.mapSetValue("View", chosen_);
  if (hidden_.isValid()) panel.mapMakeChild("Hidden").copy(hidden_);
  if (down_momentum_.isValid()) panel.mapMakeChild("Down L").copy(down_momentum_);
  QStringList off = was_shown_.keys(false);
  if (!hidden_.mapGetChild(chosen_).isValid() || off.isEmpty()) return;
  off.sort();
  rviz::Config list = panel.mapMakeChild("Switched Off");
  for (const QString& what : off) list.listAppendNew().setValue(what);
}

void ViewChoice::fitDisplays(const rviz::Config& file) {
  rviz::DisplayGroup* const displays = manager_->getRootDisplayGroup();
  const rviz::Config wanted = file.mapGetChild("Visualization Manager").mapGetChild("Displays");
  for (int k = 0; k < wanted.listLength(); ++k) {
    const rviz::Config one = wanted.listChildAt(k);
    QString name, kind;
    if (!one.mapGetString("Name", &name) || !one.mapGetString("Class", &kind)) continue;
    for (int i = 0; i < displays->numDisplays(); ++i) {
      rviz::Display* const display = displays->getDisplayAt(i);
      if (display->getName() != name || display->getClassId() != kind) continue;
      rviz::Config settings;
      for (const char* key : {"Enabled", "Namespaces", "Cell Size", "Plane Cell Count", "Offset"}) {
        const rviz::Config value = one.mapGetChild(key);
        if (value.isValid()) settings.mapMakeChild(key).copy(value);
      }
      display->load(settings);
    }
  }
}

void ViewChoice::loadViewsOf(const QString& scene) {
  if (!manager_ || scene.isEmpty() || scene.contains('/')) return;
  const QString file = QString::fromStdString(ros::package::getPath("poinsot")) + "/rviz/" + scene + ".rviz";
  if (!QFileInfo(file).isFile()) return;
  rviz::YamlConfigReader reader;
  rviz::Config config;
  reader.readFile(config, file);
  if (reader.error()) return;
  const rviz::Config views = config.mapGetChild("Visualization Manager").mapGetChild("Views");
  if (!views.isValid()) return;
  // The user has changed nothing: RViz need not ask whether to save it.
  QWidget* const window = manager_->getWindowManager() ? manager_->getWindowManager()->getParentWindow() : nullptr;
  const bool modified = window && window->isWindowModified();
  choose("");  // shows again what the old view left out
  settleProperties();
  manager_->getViewManager()->load(views);
  fitDisplays(config);
  const rviz::Config panels = config.mapGetChild("Panels");
  for (int i = 0; i < panels.listLength(); ++i) {
    QString kind;
    if (panels.listChildAt(i).mapGetString("Class", &kind) && kind == "poinsot/Panel") load(panels.listChildAt(i));
  }
  if (window) window->setWindowModified(modified);
}

}  // namespace poinsot::rviz_panel
