#include "speed_control.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <cmath>

#include "node_link.h"
#include "speed_scale.h"
#include "text.h"
#include "widgets.h"

namespace poinsot::rviz_panel {

SpeedControl::SpeedControl(NodeLink* link) : link_(link) {
  slider_ = makeSlider("speed_slider", "How fast t runs: from a hundredth to a hundred times real time.",
                       speed_scale::kPositions, 5, speed_scale::kPositions / 4);
  slider_->setTickPosition(QSlider::TicksBelow);
  slider_->setTickInterval(slider_->pageStep());
  text_ = makeLabel("", 1, true);
  text_->setObjectName("speed_text");
  auto* const real_time = makeButton<QToolButton>("×&1", "real_time", "Real time, in the direction in which it plays.");
  backwards_ = makeButton<QToolButton>("◀ &Back", "backwards", "Play backwards.");
  backwards_->setCheckable(true);
  arrange(real_time);
  showSpeed(1);

  connect(slider_, &QSlider::valueChanged, this, [this](int position) { ask(speed_scale::speedAt(position)); });
  connect(backwards_, &QToolButton::clicked, this, [this] { ask(std::abs(speed_)); });
  connect(real_time, &QToolButton::clicked, this, [this] {
    showPosition(slider_, speed_scale::positionOf(1));
    ask(1);
  });
}

void SpeedControl::arrange(QToolButton* real_time) {
  auto* const grid = makeLayout<QGridLayout>(this);
  grid->setVerticalSpacing(2);
  grid->addWidget(labelOf(slider_, "sp&eed"), 0, 0);
  grid->addWidget(text_, 0, 1);
  grid->addWidget(real_time, 0, 3);
  grid->addWidget(backwards_, 0, 4);
  grid->setColumnStretch(2, 1);
  grid->addWidget(slider_, 1, 0, 1, 5);
  auto* const ends = makeLayout<QHBoxLayout>();
  for (const double end : {speed_scale::kSlowest, 1.0, speed_scale::kFastest}) {
    if (end > speed_scale::kSlowest) ends->addStretch();
    ends->addWidget(makeLabel(text::speed(end), 0.85));
  }
  grid->addLayout(ends, 2, 0, 1, 5);
}

void SpeedControl::ask(double magnitude) {
  hold_off_.begin();
  showSpeed(backwards_->isChecked() ? -magnitude : magnitude);
  link_->setSpeed(speed_);
}

void SpeedControl::playForwards() {
  if (backwards_->isChecked()) backwards_->click();
}

void SpeedControl::showSpeed(double speed) {
  speed_ = speed;
  text_->setText(text::speed(speed));
}

void SpeedControl::showStatus(const NodeStatus& status) {
  if (slider_->isSliderDown() || hold_off_.holds()) return;
  showPosition(slider_, speed_scale::positionOf(status.speed));
  backwards_->setChecked(std::signbit(status.speed));
  showSpeed(status.speed);
}

}  // namespace poinsot::rviz_panel
