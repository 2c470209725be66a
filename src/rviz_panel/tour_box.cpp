#include "tour_box.h"

#include <ros/console.h>

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <utility>

#include "data_file.h"
#include "node_link.h"
#include "widgets.h"

namespace poinsot::rviz_panel {
namespace {

QVector<Card> cards() {
  try {
    return tourCards(data_file::read("tour.yaml"));
  } catch (const data_file::Error& error) {
    ROS_WARN("%s; there is no tour", error.what());
    return {};
  }
}

}  // namespace

TourBox::TourBox(NodeLink* link, std::function<void(const QString& view)> look)
    : link_(link), look_(std::move(look)), tour_(std::make_unique<Tour>(cards())) {
  setObjectName("tour_box");
  setFrameShape(QFrame::StyledPanel);
  title_ = makeLabel("", 1, true);
  title_->setObjectName("tour_title");
  says_ = makeWords("tour_says", 1, 3);
  back_ = makeButton<QPushButton>("Bac&k", "tour_back", "The card before.");
  next_ = makeButton<QPushButton>("Ne&xt", "tour_next", "The next card.");
  button_ = makeButton<QToolButton>("To&ur", "tour", "Leads through what there is to see, card by card.");
  button_->setCheckable(true);
  button_->setEnabled(tour_->size() > 0);
  auto* const layout = makeLayout<QVBoxLayout>(this, 4);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->addLayout(makeRow({back_, nullptr, next_}));  // on top, where they stay, however long the text is
  layout->addWidget(title_);
  layout->addWidget(says_);
  hide();

  connect(button_, &QToolButton::toggled, this, &TourBox::open);
  connect(back_, &QPushButton::clicked, this, [this] { go(-1); });
  connect(next_, &QPushButton::clicked, this, [this] { go(1); });
  connect(link, &NodeLink::statusReceived, this, &TourBox::showStatus);
  connect(link, &NodeLink::refused, this, &TourBox::fail);
  connect(link, &NodeLink::lost, this, &TourBox::fail);
}

void TourBox::open(bool opened) {
  setVisible(opened);
  if (opened) go(tour_->shown() < 0 ? 1 : 0);
}

void TourBox::go(int by) {
  act(tour_->go(by));
}

void TourBox::showStatus(const NodeStatus& status) {
  act(tour_->onStatus(status));
}

void TourBox::fail() {
  tour_->fail();
  showCard();
}

void TourBox::act(Tour::Act act) {
  switch (act) {
    case Tour::Act::nothing:
      break;
    case Tour::Act::load_scene:
      link_->loadScene(tour_->card().scene);
      break;
    case Tour::Act::set_method:
      link_->setMethod(tour_->card().body, tour_->card().method, tour_->card().step);
      break;
    case Tour::Act::arrive:
      link_->setSpeed(tour_->card().speed);
      link_->setPaused(tour_->card().paused);
      if (tour_->card().time != 0) link_->seek(tour_->card().time);
      look_(tour_->card().view);
      break;
  }
  showCard();
}

void TourBox::showCard() {
  if (!isVisible()) return;
  if (tour_->shown() < 0) {
    title_->setText("Tour");
    says_->setText(tour_->underWay() ? "The first card is being made ready …" : "The first card could not be shown.");
  } else {
    title_->setText(QString("%1 of %2: %3").arg(tour_->shown() + 1).arg(tour_->size()).arg(tour_->shownCard().title));
    says_->setText(tour_->shownCard().says);
  }
  back_->setEnabled(tour_->canGo(-1));
  next_->setEnabled(tour_->canGo(1));
}

}  // namespace poinsot::rviz_panel
