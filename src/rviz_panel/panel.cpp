#include "panel.h"

#include <rviz/config.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>
#include <pluginlib/class_list_macros.hpp>

#include <QFrame>
#include <QScrollArea>
#include <QVBoxLayout>
#include <initializer_list>

#include "background.h"
#include "banner.h"
#include "choice_list.h"
#include "eye.h"
#include "method_choice.h"
#include "node_link.h"
#include "notice.h"
#include "play_buttons.h"
#include "plots.h"
#include "read_outs.h"
#include "reset_guard.h"
#include "scene_choice.h"
#include "speed_control.h"
#include "time_control.h"
#include "tour_box.h"
#include "view_choice.h"

namespace poinsot::rviz_panel {
namespace {

constexpr int kRefreshEvery = 100;  // ms
constexpr int kWidth = 330;

QFrame* line() {
  auto* const out = new QFrame;
  out->setFrameShape(QFrame::HLine);
  out->setFrameShadow(QFrame::Sunken);
  return out;
}

}  // namespace

Panel::Panel(QWidget* parent) : rviz::Panel(parent), link_(new NodeLink(this)) {
  setObjectName("poinsot_panel");
  setMinimumWidth(260);
}

void Panel::onInitialize() {
  // Before all others: the views of another scene are there when the tour chooses one.
  connect(link_, &NodeLink::statusReceived, this, &Panel::onStatus);
  banner_ = new Banner(link_);
  auto* const scroll = new QScrollArea;
  scroll->setObjectName("scroll");
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(makePage());
  notice_ = new Notice(link_);
  auto* const layout = makeLayout<QVBoxLayout>(this, 0);
  layout->addWidget(banner_);
  layout->addWidget(scroll, 1);
  layout->addWidget(line());
  layout->addWidget(notice_);

  reset_guard_ = new ResetGuard(vis_manager_, this);
  listen();
  onLost();
}

QWidget* Panel::makePage() {
  views_ = new ViewChoice(vis_manager_);
  node_ = new QLineEdit;
  describe(node_, "node", "The name of the Poinsot node to control; press Enter. Kept in the .rviz file.");
  connect(node_, &QLineEdit::editingFinished, this, &Panel::takeTypedNode);
  auto* const page = new QWidget;
  auto* const layout = makeLayout<QVBoxLayout>(page, 6);
  layout->setContentsMargins(6, 6, 6, 6);
  body_ = makeList("body", "The body whose method is chosen here, and which is read out and plotted below.", 8);
  method_ = new MethodChoice(link_);
  read_outs_ = new ReadOuts;
  plots_ = new Plots;
  layout->addWidget(makeControls());
  layout->addWidget(line());
  layout->addLayout(makeRow({labelOf(body_, "bo&dy"), body_}));
  for (QWidget* part : std::initializer_list<QWidget*>{method_, line(), read_outs_, plots_, line(), views_}) {
    layout->addWidget(part);
  }
  layout->addLayout(makeRow({labelOf(node_, "&node"), node_, makeBackgroundBox(vis_manager_)}));
  layout->addStretch();
  return page;
}

QWidget* Panel::makeControls() {
  controls_ = new QWidget;
  controls_->setObjectName("controls");
  auto* const tour = new TourBox(link_, [this](const QString& view) { views_->chooseNamed(view); });
  auto* const scene = new SceneChoice(link_, tour->button());
  auto* const buttons = new PlayButtons(link_);
  auto* const speed = new SpeedControl(link_);
  time_ = new TimeControl(link_);
  auto* const layout = makeLayout<QVBoxLayout>(controls_, 6);
  for (QWidget* part : std::initializer_list<QWidget*>{scene, tour, line(), buttons, time_, speed}) {
    layout->addWidget(part);
  }
  connect(link_, &NodeLink::statusReceived, scene, &SceneChoice::showStatus);
  connect(link_, &NodeLink::statusReceived, buttons, &PlayButtons::showStatus);
  connect(link_, &NodeLink::statusReceived, speed, &SpeedControl::showStatus);
  return controls_;
}

void Panel::listen() {
  connect(link_, &NodeLink::stateReceived, this, &Panel::onState);
  connect(link_, &NodeLink::descriptionReceived, plots_, &Plots::setPrincipalAxes);
  connect(link_, &NodeLink::descriptionReceived, this,
          [this](const BodyDescription& description) { views_->showDescription(description); });
  connect(link_, &NodeLink::layoutReceived, this, [this](const SceneLayout& layout) { views_->showLayout(layout); });
  connect(link_, &NodeLink::bodiesOffered, this, &Panel::offer);
  connect(link_, &NodeLink::found, this, &Panel::onFound);
  connect(link_, &NodeLink::lost, this, &Panel::onLost);
  connect(link_, &NodeLink::done, notice_, &Notice::say);
  connect(link_, &NodeLink::refused, notice_, &Notice::refuse);
  connect(time_, &TimeControl::spanChanged, this, &Panel::configChanged);
  connect(&timer_, &QTimer::timeout, this, &Panel::refresh);
  timer_.start(kRefreshEvery);
}

void Panel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString node;
  if (config.mapGetString("Node", &node)) link_->setNode(node);
  showText(node_, link_->givenNode());
  time_->load(config);
  views_->load(config);
}

void Panel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Node", link_->givenNode());
  time_->save(config);
  views_->save(config);
}

QSize Panel::sizeHint() const {
  return {kWidth, 800};
}

void Panel::takeTypedNode() {
  if (!node_->isModified()) return;
  node_->setModified(false);
  const QString before = link_->givenNode();
  link_->setNode(node_->text());
  showText(node_, link_->givenNode());
  if (link_->givenNode() != before) Q_EMIT configChanged();
}

void Panel::clear() {
  newest_.reset();
  read_outs_->clear();
  plots_->clear();
}

void Panel::onStatus(const NodeStatus& status) {
  const QString scene = QString::fromStdString(status.scene);
  if (scene_ && *scene_ != scene) {
    views_->sceneChanged();
    notice_->sceneChanged();
  }
  scene_ = scene;
  notice_->showStatus(status);
  banner_->showStatus(status.waiting_for_clock);
  time_->showStatus(status);
  offer(bodyNames(status));
  method_->showStatus(status, body_->currentText());
  read_outs_->showStatus(status, body_->currentText());
}

void Panel::onState(const BodyState& state) {
  if (QString::fromStdString(state.body) != body_->currentText()) return;  // on its way when another was chosen
  newest_ = state;
  plots_->add(state);
  views_->camera().showState(state);
}

void Panel::setControllable(bool controllable) {
  controls_->setEnabled(controllable);
  method_->setEnabled(controllable);
  banner_->refresh();
}

void Panel::offer(const QStringList& bodies) {
  const QString present = body_->currentText();
  showChoices(body_, plainChoices(bodies), bodies.contains(present) || bodies.isEmpty() ? present : bodies.front());
}

void Panel::onFound() {
  setControllable(true);
  clear();
}

void Panel::onLost() {
  setControllable(false);
  showText(node_, link_->givenNode());
  notice_->forgetNode();
  clear();
}

void Panel::refresh() {
  views_->refresh();
  reset_guard_->refillDisplays();
  if (const auto eye = eyeInWorld(*vis_manager_)) link_->setEye(*eye);
  link_->setLightBackground(isBackgroundLight(*vis_manager_));
  notice_->refresh();
  banner_->refresh();
  const QString body = isVisible() ? body_->currentText() : QString();
  if (body != link_->body()) {
    clear();
    link_->setBody(body);
  }
  if (!isVisible()) return;
  if (newest_) {
    read_outs_->showState(*newest_);
    time_->showState(*newest_);
    newest_.reset();
  }
  plots_->refresh();
}

}  // namespace poinsot::rviz_panel

PLUGINLIB_EXPORT_CLASS(poinsot::rviz_panel::Panel, rviz::Panel)
