#include "time_control.h"

#include <QPalette>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "node_link.h"
#include "text.h"

namespace poinsot::rviz_panel {
namespace {

constexpr int kPositions = 2000;
constexpr std::pair<double, const char*> kSpans[] = {
    {10, "10 s"}, {60, "1 min"}, {600, "10 min"}, {3600, "1 h"}, {86400, "1 day"}};
constexpr int kUsualSpan = 1;

double seconds(const QElapsedTimer& timer) {
  return 1e-3 * static_cast<double>(timer.elapsed());
}

}  // namespace

TimeControl::TimeControl(NodeLink* link) : link_(link) {
  time_ = new LiveEdit;
  describe(time_, "time", "Simulation time t in seconds. Type a time and press Enter to be there, as 12.5 or 1e9.");
  setLetters(time_, 1.25, true);
  time_->setAlignment(Qt::AlignRight);
  QPalette palette = time_->palette();  // t can also be read where it cannot be chosen: in a recording
  palette.setColor(QPalette::Disabled, QPalette::Text, palette.color(QPalette::Active, QPalette::Text));
  time_->setPalette(palette);
  span_ = makeList("span", "How much time the slider spans. Beyond its end it turns to the next page.", 5);
  for (const auto& [seconds, text] : kSpans) span_->addItem(text, seconds);
  span_->setCurrentIndex(kUsualSpan);
  both_sides_ =
      makeButton<QToolButton>("±", "both_sides", "The slider's first page reaches as far before t = 0 as after it.");
  both_sides_->setCheckable(true);
  slider_ = makeSlider("time_slider", "Drag to be at another time; also while paused. Arrow keys go in small steps.",
                       kPositions, kPositions / 200, kPositions / 20);
  from_ = makeLabel("", 0.85);
  to_ = makeLabel("", 0.85);
  from_->setObjectName("page_from");
  to_->setObjectName("page_to");
  auto* const layout = makeLayout<QVBoxLayout>(this, 2);
  layout->addLayout(makeRow({labelOf(time_, "t&ime"), time_, new QLabel("s"), span_, both_sides_}));
  layout->addWidget(slider_);
  layout->addLayout(makeRow({from_, nullptr, to_}));

  connect(time_, &QLineEdit::returnPressed, this, &TimeControl::seekToText);
  connect(slider_, &QSlider::valueChanged, this, &TimeControl::seekToSlider);
  connect(slider_, &QSlider::sliderReleased, this, [this] { hold_off_.begin(); });
  connect(span_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &TimeControl::newPage);
  connect(both_sides_, &QToolButton::toggled, this, &TimeControl::newPage);
  connect(link, &NodeLink::resetting, this, &TimeControl::showStart);
  clock_.start();
  newPage();
}

void TimeControl::seekToSlider() {
  hold_off_.begin();
  asked_.end();
  now_ = page_.timeAt(static_cast<double>(slider_->value()) / kPositions);
  time_->setText(text::time(now_));
  link_->seek(now_);
}

void TimeControl::seekToText() {
  bool ok = false;
  const double time = text::number(time_->text(), &ok);
  time_->setModified(false);
  if (!ok || !std::isfinite(time)) {
    link_->refuse(QString("Expected a time in seconds, got “%1”.").arg(time_->text()));
    return;
  }
  hold_off_.end();
  asked_.ask(seconds(clock_));
  display(time);
  link_->seek(time);
}

void TimeControl::load(const rviz::Config& panel) {
  float span = 0;
  bool both_sides = false;
  panel.mapGetFloat("Time Span", &span);
  panel.mapGetBool("Negative Times", &both_sides);
  const int index = span_->findData(static_cast<double>(span));
  if (index >= 0) span_->setCurrentIndex(index);
  both_sides_->setChecked(both_sides);
}

void TimeControl::save(rviz::Config panel) const {
  panel.mapSetValue("Time Span", span_->currentData());
  panel.mapSetValue("Negative Times", both_sides_->isChecked());
}

void TimeControl::newPage() {
  page_ = TimePage(span_->currentData().toDouble(), both_sides_->isChecked());
  page_.turnTo(now_);
  showPage();
  Q_EMIT spanChanged();
}

void TimeControl::showPage() {
  from_->setText(text::plain(page_.from(), 12) + " s");
  to_->setText(text::plain(page_.to(), 12) + " s");
  showOnSlider();
}

void TimeControl::showOnSlider() {
  showPosition(slider_, static_cast<int>(std::lround(kPositions * page_.shareAt(now_))));
}

void TimeControl::showStatus(const NodeStatus& status) {
  showTime(status.time, status.segment, isSeeking(status));
}

void TimeControl::showState(const BodyState& state) {
  showTime(state.time, state.segment, false);
}

void TimeControl::showTime(double time, std::uint32_t segment, bool seeking) {
  const bool hidden = asked_.hides(segment, seeking, seconds(clock_));
  if (hidden || slider_->isSliderDown() || hold_off_.holds()) return;
  display(time);
}

void TimeControl::display(double time) {
  now_ = time;
  showText(time_, text::time(time));
  const double from = page_.from();
  page_.turnTo(time);
  if (page_.from() == from) {
    showOnSlider();
  } else {
    showPage();
  }
}

void TimeControl::showStart() {
  hold_off_.end();
  asked_.end();
  now_ = 0;
  // Not turned to: t = 0 is also the end of the page before.
  page_ = TimePage(span_->currentData().toDouble(), both_sides_->isChecked());
  showPage();
}

}  // namespace poinsot::rviz_panel
