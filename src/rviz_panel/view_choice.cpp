#include "view_choice.h"

#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>
#include <rviz/window_manager_interface.h>

#include <QCoreApplication>
#include <QPushButton>
#include <optional>

#include "view_file.h"
#include "widgets.h"

namespace poinsot::rviz_panel {
namespace {

constexpr int kColumns = 3;

/**
 * RViz sends its list of views calls with bare pointers to properties of a new one; they are to have arrived before
 * another one takes its place.
 */
void settleProperties() {
  QCoreApplication::sendPostedEvents(nullptr, QEvent::MetaCall);
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
  rviz::ViewManager* const views = manager_->getViewManager();
  if (index >= views->getNumViews()) return;
  settleProperties();
  views->setCurrentFrom(views->getViewAt(index));
  choose(views->getViewAt(index)->getName());
  camera_.look();
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

void ViewChoice::loadViewsOf(const QString& scene) {
  const std::optional<rviz::Config> file = view_file::read(scene);
  if (!file) return;
  // The user has changed nothing: RViz need not ask whether to save it.
  QWidget* const window = manager_->getWindowManager() ? manager_->getWindowManager()->getParentWindow() : nullptr;
  const bool modified = window && window->isWindowModified();
  choose("");  // shows again what the old view left out
  settleProperties();
  manager_->getViewManager()->load(view_file::viewsOf(*file));
  view_file::fitDisplays(*manager_->getRootDisplayGroup(), *file);
  if (const std::optional<rviz::Config> panel = view_file::panelOf(*file)) load(*panel);
  if (window) window->setWindowModified(modified);
}

}  // namespace poinsot::rviz_panel
