#include "transport.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "speed_scale.h"
#include "text.h"
#include "widgets.h"

namespace poinsot::rviz_panel {
namespace {

constexpr int kTimePositions = 2000;
constexpr int kHoldOff = 500;  // ms

struct Span {
  double seconds;
  const char* text;
};
constexpr std::array<Span, 5> kSpans = {
    {{10, "10 s"}, {60, "1 min"}, {600, "10 min"}, {3600, "1 h"}, {86400, "1 day"}}};

QLabel* smallPrint(const QString& text) {
  auto* const label = new QLabel(text);
  QFont small = label->font();
  small.setPointSizeF(0.85 * small.pointSizeF());
  label->setFont(small);
  return label;
}

bool recent(const QElapsedTimer& timer) {
  return timer.isValid() && !timer.hasExpired(kHoldOff);
}

}  // namespace

Transport::Transport(QWidget* parent) : QWidget(parent) {
  auto* const layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  buildButtons();
  buildTime();
  buildSpeed();
  newPage();
  showSpeed(1);
}

void Transport::buildButtons() {
  auto* const row = new QHBoxLayout;
  row->setSpacing(4);
  reset_ = new QPushButton(style()->standardIcon(QStyle::SP_MediaSkipBackward), "&Reset");
  describe(reset_, "reset",
           "Back to t = 0 and the spins of the scene, to play forwards. Methods, pause and speed stay as they are.");
  play_ = new QPushButton(style()->standardIcon(QStyle::SP_MediaPause), "&Pause");
  describe(play_, "play", "Pause, or play on.");
  step_ = new QPushButton(style()->standardIcon(QStyle::SP_MediaSeekForward), "S&tep");
  describe(step_, "step", "While paused: one frame further.");
  for (QPushButton* button : {reset_, play_, step_}) row->addWidget(button, button == play_ ? 3 : 2);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);

  connect(play_, &QPushButton::clicked, this, &Transport::askPause);
  connect(step_, &QPushButton::clicked, this, &Transport::stepAsked);
  connect(reset_, &QPushButton::clicked, this, [this] {
    since_seek_.invalidate();
    page_ = TimePage(span(), bothSides());  // t = 0 is also the end of the page before
    now_ = 0;
    showPage();
    if (backwards_->isChecked()) backwards_->click();  // nobody starts again in order to leave the start behind
    Q_EMIT resetAsked();
  });
}

void Transport::buildTime() {
  auto* const grid = new QGridLayout;
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(2);

  auto* const label = new QLabel("t&ime");
  time_ = new LiveEdit;
  describe(time_, "time", "Simulation time t in seconds. Type a time and press Enter to be there, as 12.5 or 1e9.");
  QFont large = time_->font();
  large.setPointSizeF(1.25 * large.pointSizeF());
  large.setBold(true);
  time_->setFont(large);
  time_->setAlignment(Qt::AlignRight);
  label->setBuddy(time_);
  span_ = new QComboBox;
  describe(span_, "span", "How much time the slider spans. Beyond its end it turns to the next page.");
  for (const Span& span : kSpans) span_->addItem(span.text, span.seconds);
  span_->setCurrentIndex(1);
  leaveWheelToPanel(span_);
  both_sides_ = new QToolButton;
  both_sides_->setText("±");
  both_sides_->setCheckable(true);
  describe(both_sides_, "both_sides", "The slider's first page reaches as far before t = 0 as after it.");

  time_slider_ = new JumpSlider;
  describe(time_slider_, "time_slider", "Drag to be at another time; also while paused. Arrow keys go in small steps.");
  time_slider_->setRange(0, kTimePositions);
  time_slider_->setSingleStep(kTimePositions / 200);
  time_slider_->setPageStep(kTimePositions / 20);
  page_from_ = smallPrint("");
  page_to_ = smallPrint("");
  page_from_->setObjectName("page_from");
  page_to_->setObjectName("page_to");

  grid->addWidget(label, 0, 0);
  grid->addWidget(time_, 0, 1);
  grid->addWidget(new QLabel("s"), 0, 2);
  grid->addWidget(span_, 0, 3);
  grid->addWidget(both_sides_, 0, 4);
  grid->addWidget(time_slider_, 1, 0, 1, 5);
  auto* const ends = new QHBoxLayout;
  ends->addWidget(page_from_);
  ends->addStretch();
  ends->addWidget(page_to_);
  grid->addLayout(ends, 2, 0, 1, 5);
  grid->setColumnStretch(1, 1);
  static_cast<QVBoxLayout*>(layout())->addLayout(grid);

  connect(time_, &QLineEdit::returnPressed, this, &Transport::seekToText);
  connect(time_slider_, &QSlider::valueChanged, this, &Transport::seekToSlider);
  connect(time_slider_, &QSlider::sliderReleased, this, [this] { since_seek_.start(); });
  connect(span_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &Transport::newPage);
  connect(both_sides_, &QToolButton::toggled, this, &Transport::newPage);
}

void Transport::buildSpeed() {
  auto* const grid = new QGridLayout;
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(2);
  auto* const label = new QLabel("sp&eed");
  speed_slider_ = new JumpSlider;
  describe(speed_slider_, "speed_slider", "How fast t runs: from a hundredth to a hundred times real time.");
  speed_slider_->setRange(0, speed_scale::kPositions);
  speed_slider_->setSingleStep(5);
  speed_slider_->setPageStep(speed_scale::kPositions / 4);
  speed_slider_->setTickPosition(QSlider::TicksBelow);
  speed_slider_->setTickInterval(speed_scale::kPositions / 4);
  label->setBuddy(speed_slider_);
  speed_text_ = new QLabel;
  speed_text_->setObjectName("speed_text");
  QFont bold = speed_text_->font();
  bold.setBold(true);
  speed_text_->setFont(bold);
  real_time_ = new QToolButton;
  real_time_->setText("×&1");
  describe(real_time_, "real_time", "Real time, in the direction in which it plays.");
  backwards_ = new QToolButton;
  backwards_->setText("◀ &Back");
  backwards_->setCheckable(true);
  describe(backwards_, "backwards", "Play backwards.");

  grid->addWidget(label, 0, 0);
  grid->addWidget(speed_text_, 0, 1);
  grid->addWidget(real_time_, 0, 3);
  grid->addWidget(backwards_, 0, 4);
  grid->setColumnStretch(2, 1);
  grid->addWidget(speed_slider_, 1, 0, 1, 5);
  auto* const ends = new QHBoxLayout;
  for (const double end : {speed_scale::kSlowest, 1.0, speed_scale::kFastest}) {
    if (end > speed_scale::kSlowest) ends->addStretch();
    ends->addWidget(smallPrint(text::speed(end)));
  }
  grid->addLayout(ends, 2, 0, 1, 5);
  static_cast<QVBoxLayout*>(layout())->addLayout(grid);

  connect(speed_slider_, &QSlider::valueChanged, this,
          [this](int position) { askSpeed(speed_scale::speedAt(position)); });
  connect(backwards_, &QToolButton::clicked, this, [this] { askSpeed(std::abs(speed_)); });
  connect(real_time_, &QToolButton::clicked, this, [this] {
    const QSignalBlocker quiet(speed_slider_);
    speed_slider_->setValue(speed_scale::positionOf(1));
    askSpeed(1);
  });
}

void Transport::askPause() {
  since_pause_.start();
  showPaused(!paused_);
  Q_EMIT pauseAsked(paused_);
}

void Transport::askSpeed(double magnitude) {
  since_speed_.start();
  showSpeed(backwards_->isChecked() ? -magnitude : magnitude);
  Q_EMIT speedAsked(speed_);
}

void Transport::seekToSlider() {
  since_seek_.start();
  const double share = static_cast<double>(time_slider_->value()) / kTimePositions;
  now_ = page_.timeAt(share);
  time_->setText(text::time(now_));
  Q_EMIT seekAsked(now_);
}

void Transport::seekToText() {
  bool ok = false;
  const double time = text::number(time_->text(), &ok);
  if (!ok || !std::isfinite(time)) {
    Q_EMIT refused(QString("“%1” is not a time in seconds.").arg(time_->text()));
    time_->setModified(false);
    return;
  }
  time_->setModified(false);
  since_seek_.invalidate();
  Q_EMIT seekAsked(time);
}

double Transport::span() const {
  return span_->currentData().toDouble();
}

bool Transport::bothSides() const {
  return both_sides_->isChecked();
}

void Transport::setSpan(double span, bool both_sides) {
  const int index = span_->findData(span);
  if (index >= 0) span_->setCurrentIndex(index);
  both_sides_->setChecked(both_sides);
}

void Transport::newPage() {
  page_ = TimePage(span(), bothSides());
  page_.turnTo(now_);
  showPage();
  Q_EMIT spanChanged();
}

void Transport::showPage() {
  page_from_->setText(text::plain(page_.from(), 12) + " s");
  page_to_->setText(text::plain(page_.to(), 12) + " s");
  const QSignalBlocker quiet(time_slider_);
  time_slider_->setValue(static_cast<int>(std::lround(kTimePositions * page_.shareAt(now_))));
}

void Transport::showTime(double time) {
  if (time_slider_->isSliderDown() || recent(since_seek_)) return;
  now_ = time;
  showText(time_, text::time(time));
  const double from = page_.from();
  page_.turnTo(time);
  if (page_.from() != from) {
    showPage();
    return;
  }
  const QSignalBlocker quiet(time_slider_);
  time_slider_->setValue(static_cast<int>(std::lround(kTimePositions * page_.shareAt(time))));
}

void Transport::showSpeed(double speed) {
  speed_ = speed;
  speed_text_->setText(text::speed(speed));
}

void Transport::showPaused(bool paused) {
  step_->setEnabled(paused);
  if (paused == paused_) return;
  paused_ = paused;
  play_->setIcon(style()->standardIcon(paused ? QStyle::SP_MediaPlay : QStyle::SP_MediaPause));
  play_->setText(paused ? "&Play" : "&Pause");
}

void Transport::showStatus(const NodeStatus& status) {
  if (!recent(since_pause_)) showPaused(status.paused);
  showTime(status.time);
  if (speed_slider_->isSliderDown() || recent(since_speed_)) return;
  const QSignalBlocker quiet(speed_slider_);
  speed_slider_->setValue(speed_scale::positionOf(status.speed));
  backwards_->setChecked(std::signbit(status.speed));
  showSpeed(status.speed);
}

}  // namespace poinsot::rviz_panel
