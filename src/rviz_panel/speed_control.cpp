#include "speed_control.h"

#include <QVBoxLayout>
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
  auto* const layout = makeLayout<QVBoxLayout>(this, 2);
  layout->addLayout(makeRow({labelOf(slider_, "sp&eed"), text_, nullptr, real_time, backwards_}, 2));
  layout->addWidget(slider_);
  layout->addLayout(
      makeRow({makeLabel(text::speed(speed_scale::kSlowest), 0.85), nullptr, makeLabel(text::speed(1), 0.85), nullptr,
               makeLabel(text::speed(speed_scale::kFastest), 0.85)}));
  showSpeed(1);

  connect(slider_, &QSlider::valueChanged, this, [this](int position) { ask(speed_scale::speedAt(position)); });
  connect(backwards_, &QToolButton::clicked, this, [this] { ask(std::abs(speed_)); });
  connect(link, &NodeLink::resetting, this, [this] {
    if (backwards_->isChecked()) backwards_->click();  // after a reset t is to run forwards
  });
  connect(real_time, &QToolButton::clicked, this, [this] {
    showPosition(slider_, speed_scale::positionOf(1));
    ask(1);
  });
}

void SpeedControl::ask(double magnitude) {
  hold_off_.begin();
  showSpeed(backwards_->isChecked() ? -magnitude : magnitude);
  link_->setSpeed(speed_);
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
