#include "view_choice.h"

#include <rviz/render_panel.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>
#include <rviz/window_manager_interface.h>
#include <rviz/yaml_config_writer.h>

#include <QCoreApplication>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "displays.h"
#include "scene_views.h"
#include "widgets.h"

namespace poinsot::rviz_panel {
namespace {

constexpr int kColumns = 3;
constexpr double kCell = 3;  // of the floor, in radii of a picture
constexpr int kLeastCells = 8, kMostCells = 60;

/**
 * RViz sends its list of views calls with bare pointers to properties of a new one; they are to have arrived before
 * another one takes its place.
 */
void settleProperties() {
  QCoreApplication::sendPostedEvents(nullptr, QEvent::MetaCall);
}

/** All settings of a camera but its name. */
QString textOf(const rviz::ViewController& camera) {
  rviz::Config config;
  camera.save(config);
  config.mapSetValue("Name", "");
  return rviz::YamlConfigWriter().writeString(config);
}

}  // namespace

ViewChoice::ViewChoice(rviz::VisualizationManager* manager) : manager_(manager), camera_(manager->getViewManager()) {
  auto* const layout = makeLayout<QGridLayout>(this);
  title_ = new QLabel("view");
  title_->hide();
  buttons_ = makeLayout<QGridLayout>();
  layout->addWidget(title_, 0, 0, Qt::AlignTop);
  layout->addLayout(buttons_, 0, 1);
  layout->setColumnStretch(1, 1);
}

void ViewChoice::refresh() {
  const QWidget* const picture = manager_->getRenderPanel();
  const double aspect =
      picture && picture->height() > 0 ? static_cast<double>(picture->width()) / picture->height() : 0;
  if (aspect > 0 && aspect != aspect_) {
    aspect_ = aspect;
    fit();
  }
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
    auto* const button =
        makeButton<QPushButton>(names[i], QString("view_%1").arg(i), "Look from there: “" + names[i] + "”.");
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
  const rviz::ViewManager& views = *manager_->getViewManager();
  if (index < views.getNumViews()) take(views.getViewAt(index));
}

void ViewChoice::chooseNamed(const QString& view) {
  if (rviz::ViewController* const found = saved(view)) take(found);
}

void ViewChoice::take(rviz::ViewController* view) {
  rviz::ViewManager* const views = manager_->getViewManager();
  settleProperties();
  views->setCurrentFrom(view);
  choose(view->getName());
  camera_.look();
  set_ = textOf(*views->getCurrent());
}

rviz::ViewController* ViewChoice::saved(const QString& view) const {
  const rviz::ViewManager& views = *manager_->getViewManager();
  for (int i = 0; i < views.getNumViews(); ++i) {
    if (views.getViewAt(i)->getName() == view) return views.getViewAt(i);
  }
  return nullptr;
}

void ViewChoice::choose(const QString& view) {
  if (view != chosen_) {
    const rviz::DisplayGroup& displays = *manager_->getRootDisplayGroup();
    hidden_.bringBack(displays, chosen_);
    hidden_.remember(displays, view);
    hidden_.hide(displays, view);
    chosen_ = view;
  }
  camera_.take(view);
  markChosen();
}

void ViewChoice::markChosen() {
  for (int i = 0; i < buttons_->count(); ++i) {
    if (auto* const button = qobject_cast<QPushButton*>(buttons_->itemAt(i)->widget())) {
      button->setChecked(button->text() == chosen_);
      const bool is_of_picture = button->text() == scene_views::kRiding || button->text() == scene_views::kAlongL;
      button->setEnabled(!is_of_picture || !layout_ || hasPicture());
    }
  }
}

void ViewChoice::load(const rviz::Config& panel) {
  chosen_.clear();
  panel.mapGetString("View", &chosen_);
  camera_.load(panel);
  camera_.take(chosen_);
  hidden_.load(panel);
  // What is hidden now has been hidden by this view, as the file was saved, and not by the user.
  hidden_.hide(*manager_->getRootDisplayGroup(), chosen_);
  markChosen();
}

void ViewChoice::save(rviz::Config panel) const {
  if (!chosen_.isEmpty()) panel.mapSetValue("View", chosen_);
  hidden_.save(panel, chosen_);
  camera_.save(panel);
}

void ViewChoice::showLayout(const SceneLayout& layout) {
  if (!scene_views::isUsable(layout)) return;
  const bool is_first = !layout_;
  const bool fits_other_bodies = !layout_ || layout_->bodies != layout.bodies || layout_->pictures != layout.pictures;
  layout_ = layout;
  if (is_first && isAsSaved()) set_ = textOf(*manager_->getViewManager()->getCurrent());
  if (fits_other_bodies) {
    // A panel that is hidden follows no body: then it is the first.
    const auto& bodies = layout.bodies;
    if (!bodies.empty() && std::find(bodies.begin(), bodies.end(), body_) == bodies.end()) {
      body_ = bodies.front();
      frame_ = layout.frames.front();
      camera_.follow(scene_views::kAlongL, QString::fromStdString(body_));
    }
    hidden_.set(scene_views::hiddenFor(layout, body_), *manager_->getRootDisplayGroup(), chosen_);
  }
  fit();
}

void ViewChoice::showDescription(const BodyDescription& description) {
  camera_.showDescription(description);
  if (description.body == body_ && description.header.frame_id == frame_) return;
  body_ = description.body;
  frame_ = description.header.frame_id;
  camera_.follow(scene_views::kAlongL, QString::fromStdString(body_));
  if (!layout_) return;
  hidden_.set(scene_views::hiddenFor(*layout_, body_), *manager_->getRootDisplayGroup(), chosen_);
  fit();
}

bool ViewChoice::isAsSaved() const {
  const rviz::ViewController* const view = saved(chosen_);
  return view && textOf(*view) == textOf(*manager_->getViewManager()->getCurrent());
}

bool ViewChoice::hasPicture() const {
  return layout_ && std::find(layout_->pictures.begin(), layout_->pictures.end(), body_) != layout_->pictures.end();
}

bool ViewChoice::isUntouched() const {
  const rviz::ViewController* const camera = manager_->getViewManager()->getCurrent();
  return camera && textOf(*camera) == set_;
}

void ViewChoice::fit() {
  if (!layout_ || !(aspect_ > 0)) return;
  // The user has changed nothing: RViz need not ask whether to save it.
  QWidget* const window = manager_->getWindowManager() ? manager_->getWindowManager()->getParentWindow() : nullptr;
  const bool modified = window && window->isWindowModified();
  settleProperties();
  fitView(scene_views::overviewOf(*layout_, aspect_));
  if (hasPicture()) {
    fitView(scene_views::ridingOf(*layout_, frame_));
    fitView(scene_views::alongOf(*layout_, frame_));
  }
  fitFloor();
  markChosen();
  if (window) window->setWindowModified(modified);
}

void ViewChoice::fitView(const rviz::Config& view) {
  QString name;
  view.mapGetString("Name", &name);
  if (rviz::ViewController* const found = saved(name)) found->load(view);
  if (name != chosen_ || !isUntouched()) return;
  rviz::ViewManager* const views = manager_->getViewManager();
  rviz::Config present;
  present.copy(view);
  present.mapSetValue("Name", "Current View");
  views->getCurrent()->load(present);
  if (name == scene_views::kAlongL) camera_.look();
  set_ = textOf(*views->getCurrent());
}

void ViewChoice::fitFloor() {
  double lowest = 0, left = 0, right = 0;
  for (std::size_t i = 0; i < layout_->centres.size(); ++i) {
    const geometry_msgs::Point& p = layout_->centres[i];
    const double r = layout_->radii[i];
    lowest = i == 0 ? p.z - r : std::min(lowest, p.z - r);
    left = i == 0 ? p.y - r : std::min(left, p.y - r);
    right = i == 0 ? p.y + r : std::max(right, p.y + r);
  }
  const double radius = layout_->picture_radius, cell = kCell * radius;
  for (rviz::Display* const display : displaysOf(*manager_->getRootDisplayGroup())) {
    if (display->getName() != "Floor" || display->getClassId() != "rviz/Grid") continue;
    display->subProp("Cell Size")->setValue(cell);
    display->subProp("Plane Cell Count")
        ->setValue(std::clamp(static_cast<int>(std::ceil(1.5 * (right - left) / cell)), kLeastCells, kMostCells));
    display->subProp("Offset")->subProp("Y")->setValue(0.5 * (left + right));
    display->subProp("Offset")->subProp("Z")->setValue(lowest - 0.1 * radius);
  }
}

}  // namespace poinsot::rviz_panel
