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

#include <QCheckBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "colours.h"
#include "widgets.h"

namespace poinsot::rviz_panel {
namespace {

constexpr int kLookEvery = 300;  // ms
constexpr int kColumns = 3;

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
  views->setCurrentFrom(views->getViewAt(index));
  choose(views->getViewAt(index)->getName());
}

void ViewChoice::choose(const QString& view) {
  if (view != chosen_) {
    setShown(chosen_, true);
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

void ViewChoice::setShown(const QString& view, bool shown) {
  rviz::DisplayGroup* const displays = manager_->getRootDisplayGroup();
  for (int i = 0; i < displays->numDisplays(); ++i) {
    rviz::Display* const display = displays->getDisplayAt(i);
    const rviz::Config what = hidden_.mapGetChild(view).mapGetChild(display->getName());
    if (what.getType() == rviz::Config::Value) {
      display->setEnabled(shown);
    } else if (what.getType() == rviz::Config::List) {
      rviz::Config settings;
      rviz::Config namespaces = settings.mapMakeChild("Namespaces");
      for (int k = 0; k < what.listLength(); ++k) {
        namespaces.mapSetValue(what.listChildAt(k).getValue().toString(), shown);
      }
      // RViz keeps nothing of a namespace that is hidden: what stands still is sent only to a newcomer.
      const bool enabled = display->isEnabled();
      display->setEnabled(false);
      display->load(settings);
      display->setEnabled(enabled);
    }
  }
}

void ViewChoice::load(const rviz::Config& panel) {
  hidden_ = panel.mapGetChild("Hidden");
  QString view;
  if (panel.mapGetString("View", &view)) choose(view);
}

void ViewChoice::save(rviz::Config panel) const {
  if (!chosen_.isEmpty()) panel.mapSetValue("View", chosen_);
  if (hidden_.isValid()) panel.mapMakeChild("Hidden").copy(hidden_);
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
