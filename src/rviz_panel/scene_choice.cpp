#include "scene_choice.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QToolButton>

#include "node_link.h"
#include "text.h"
#include "widgets.h"

namespace poinsot::rviz_panel {

SceneChoice::SceneChoice(NodeLink* link) {
  scene_ = makeList("scene", "The scene that plays. What plays goes on until the other is ready.", 12);
  auto* const open = makeButton<QToolButton>("&Open…", "open_scene", "Play a scene file of your own.");
  setLayout(makeRow({labelOf(scene_, "&scene"), scene_, open}));

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
  QStringList scenes = text::list(status.scenes);
  if (!scenes.contains(present_)) scenes.prepend(present_);
  showChoices(scene_, scenes, present_);
}

}  // namespace poinsot::rviz_panel
