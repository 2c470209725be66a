#include "view_choice.h"

#include <ros/package.h>
#include <rviz/config.h>
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
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    connect(button, &QPushButton::clicked, this, [this, i] { take(i); });
    buttons_->addWidget(button, i / kColumns, i % kColumns);
  }
  title_->setVisible(!names.isEmpty());
}

void ViewChoice::take(int index) {
  rviz::ViewManager* const views = manager_->getViewManager();
  if (index < views->getNumViews()) views->setCurrentFrom(views->getViewAt(index));
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
  manager_->getViewManager()->load(views);
  if (window) window->setWindowModified(modified);
}

}  // namespace poinsot::rviz_panel
