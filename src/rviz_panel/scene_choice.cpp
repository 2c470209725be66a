#include "scene_choice.h"

#include <ros/console.h>

#include <QFileDialog>
#include <QFileInfo>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "data_file.h"
#include "node_link.h"
#include "text.h"
#include "widgets.h"

namespace poinsot::rviz_panel {

SceneChoice::SceneChoice(NodeLink* link, QWidget* beside) {
  scene_ = makeList("scene", "The scene that plays. What plays goes on until the other is ready.", 12);
  auto* const open = makeButton<QToolButton>("&Open…", "open_scene", "Play a scene file of your own.");
  showWords(scene_);
  shows_ = makeWords("scene_words", 0.85, 1);
  auto* const layout = makeLayout<QVBoxLayout>(this, 2);
  layout->addLayout(makeRow({labelOf(scene_, "&scene"), scene_, open, beside}));
  layout->addWidget(shows_);
  try {
    groups_ = sceneGroups(data_file::read("scenes.yaml"));
  } catch (const data_file::Error& error) {
    ROS_WARN("%s; scenes are listed without groups", error.what());
  }

  connect(scene_, QOverload<int>::of(&QComboBox::activated), this, [this, link] {
    hold_off_.begin();
    const QString chosen = scene_->currentText();
    link->loadScene(chosen == present_ ? QString() : chosen);  // empty: the present one once more
  });
  connect(open, &QToolButton::clicked, this, [this, link] {
    const QString file = QFileDialog::getOpenFileName(this, "Play a scene file", QFileInfo(file_).path(),
                                                      "Scene files (*.yaml *.yml);;All files (*)");
    if (!file.isEmpty()) link->loadScene(QFileInfo(file).absoluteFilePath());
  });
}

void SceneChoice::showStatus(const NodeStatus& status) {
  file_ = QString::fromStdString(status.scene_file);
  if (hold_off_.holds(isChanging(status))) return;
  present_ = status.scene.empty() ? "(from a parameter)" : QString::fromStdString(status.scene);
  showScenes(text::list(status.scenes));
}

void SceneChoice::showScenes(const QStringList& scenes) {
  Choices choices = groupedChoices(groups_, scenes);
  if (!scenes.contains(present_)) choices.prepend({present_, {}});
  showChoices(scene_, choices, present_);
  const auto now = std::find_if(choices.begin(), choices.end(),
                                [this](const Choice& choice) { return !choice.heading && choice.name == present_; });
  shows_->setText(now->words);
  shows_->setVisible(!now->words.isEmpty());
}

}  // namespace poinsot::rviz_panel
