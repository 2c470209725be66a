#include "play_buttons.h"

#include <QHBoxLayout>
#include <QStyle>

#include "node_link.h"
#include "widgets.h"

namespace poinsot::rviz_panel {

PlayButtons::PlayButtons(NodeLink* link) {
  auto* const reset = makeButton<QPushButton>(
      "&Reset", "reset",
      "Back to t = 0 and the spins of the scene, to play forwards. Methods, pause and speed stay as they are.");
  reset->setIcon(style()->standardIcon(QStyle::SP_MediaSkipBackward));
  play_ = makeButton<QPushButton>("&Pause", "play", "Pause, or play on.");
  play_->setIcon(style()->standardIcon(QStyle::SP_MediaPause));
  step_ = makeButton<QPushButton>("S&tep", "step", "While paused: one frame further.");
  step_->setIcon(style()->standardIcon(QStyle::SP_MediaSeekForward));
  auto* const row = makeLayout<QHBoxLayout>(this);
  for (QPushButton* button : {reset, play_, step_}) row->addWidget(button, button == play_ ? 3 : 2);

  connect(reset, &QPushButton::clicked, link, &NodeLink::reset);
  connect(step_, &QPushButton::clicked, link, &NodeLink::step);
  connect(play_, &QPushButton::clicked, this, [this, link] {
    hold_off_.begin();
    showPaused(!paused_);
    link->setPaused(paused_);
  });
}

void PlayButtons::showStatus(const NodeStatus& status) {
  if (!hold_off_.holds()) showPaused(status.paused);
}

void PlayButtons::showPaused(bool paused) {
  step_->setEnabled(paused);
  if (paused == paused_) return;
  paused_ = paused;
  play_->setIcon(style()->standardIcon(paused ? QStyle::SP_MediaPlay : QStyle::SP_MediaPause));
  play_->setText(paused ? "&Play" : "&Pause");
}

}  // namespace poinsot::rviz_panel
