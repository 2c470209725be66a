#include "scene_choice.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "status.h"
#include "widgets.h"

namespace poinsot::rviz_panel {
SceneChoice::SceneChoice(QWidget* parent) : QWidget(parent) {
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  auto* const label = new QLabel("&scene");
  scene_ = new QComboBox;
  describe(scene_, "scene", "The scene that plays. What plays goes on until the other is ready.");
  leaveWheelToPanel(scene_);
  scene_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  scene_->setMinimumContentsLength(12);
  scene_->setMaxVisibleItems(30);
  label->setBuddy(scene_);
  open_ = new QToolButton;
  open_->setText("&Open…");
  describe(open_, "open_scene", "Play a scene file of your own.");
  row->addWidget(label);
  row->addWidget(scene_, 1);
  row->addWidget(open_);

  connect(scene_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    since_asked_.start();
    Q_EMIT sceneAsked(scene_->currentText() == present_ ? QString() : scene_->currentText());
  });
  connect(open_, &QToolButton::clicked, this, &SceneChoice::open);
}

void SceneChoice::open() {
  const QString file = QFileDialog::getOpenFileName(this, "Play a scene file", QFileInfo(file_).path(),
                                                    "Scene files (*.yaml *.yml);;All files (*)");
  if (!file.isEmpty()) Q_EMIT sceneAsked(QFileInfo(file).absoluteFilePath());
}

void SceneChoice::showStatus(const NodeStatus& status) {
  file_ = QString::fromStdString(status.scene_file);
  if (since_asked_.isValid() && (!since_asked_.hasExpired(kHoldOff) || changing(status))) return;
  since_asked_.invalidate();
  QStringList scenes;
  for (const std::string& scene : status.scenes) scenes << QString::fromStdString(scene);
  present_ = QString::fromStdString(status.scene);
  if (present_.isEmpty()) present_ = "(from a parameter)";
  if (!scenes.contains(present_)) scenes.prepend(present_);
  showChoices(scene_, scenes, present_);
}

}  // namespace poinsot::rviz_panel
