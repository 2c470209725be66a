#include "panel.h"

#include <rviz/config.h>
#include <rviz/visualization_manager.h>
#include <pluginlib/class_list_macros.hpp>

#include <QFrame>
#include <QScrollArea>
#include <QVBoxLayout>
#include <initializer_list>

#include "background.h"
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
  banner_ = new QLabel;
  banner_->setObjectName("banner");
  banner_->setWordWrap(true);
  banner_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  banner_->setMargin(8);
  banner_->setStyleSheet("QLabel { background: #fff3d6; color: #5a3a00; border-bottom: 1px solid #e69f00; }");
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
  layout->addWidget(makeControls());
  layout->addWidget(line());
  layout->addWidget(views_);
  layout->addLayout(makeRow({labelOf(node_, "&node"), node_, makeBackgroundBox(vis_manager_)}));
  layout->addStretch();
  return page;
}

QWidget* Panel::makeControls() {
  controls_ = new QWidget;
  controls_->setObjectName("controls");
  auto* const scene = new SceneChoice(link_);
  auto* const buttons = new PlayButtons(link_);
  auto* const speed = new SpeedControl(link_);
  time_ = new TimeControl(link_);
  method_ = new MethodChoice(link_);
  read_outs_ = new ReadOuts;
  plots_ = new Plots;
  auto* const layout = makeLayout<QVBoxLayout>(controls_, 6);
  for (QWidget* part : std::initializer_list<QWidget*>{scene, line(), buttons, time_, speed, line(), method_, line(),
                                                       read_outs_, plots_}) {
    layout->addWidget(part);
  }
  connect(link_, &NodeLink::statusReceived, scene, &SceneChoice::showStatus);
  connect(link_, &NodeLink::statusReceived, buttons, &PlayButtons::showStatus);
  connect(link_, &NodeLink::statusReceived, speed, &SpeedControl::showStatus);
  return controls_;
}

void Panel::listen() {
  connect(link_, &NodeLink::statusReceived, this, &Panel::onStatus);
  connect(link_, &NodeLink::stateReceived, this, &Panel::onState);
  connect(link_, &NodeLink::descriptionReceived, plots_, &Plots::setPrincipalAxes);
  connect(link_, &NodeLink::descriptionReceived, this,
          [this](const BodyDescription& description) { views_->camera().showDescription(description); });
  connect(link_, &NodeLink::found, this, [this] {
    controls_->setEnabled(true);
    banner_->hide();
    clear();
  });
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
  showText(node_, link_->node());
  time_->load(config);
  views_->load(config);
}

void Panel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Node", link_->node());
  time_->save(config);
  views_->save(config);
}

QSize Panel::sizeHint() const {
  return {kWidth, 800};
}

void Panel::takeTypedNode() {
  if (!node_->isModified()) return;
  node_->setModified(false);
  const QString before = link_->node();
  link_->setNode(node_->text());
  showText(node_, link_->node());
  if (link_->node() != before) Q_EMIT configChanged();
}

void Panel::clear() {
  newest_.reset();
  read_outs_->clear();
  plots_->clear();
}

void Panel::onStatus(const NodeStatus& status) {
  const QString scene = QString::fromStdString(status.scene);
  if (scene_ && *scene_ != scene) {
    views_->loadViewsOf(scene);
    notice_->sceneChanged();
  }
  scene_ = scene;
  notice_->showStatus(status);
  time_->showStatus(status);
  method_->showStatus(status);
  read_outs_->showStatus(status, method_->body());
}

void Panel::onState(const BodyState& state) {
  if (QString::fromStdString(state.body) != method_->body()) return;  // on its way when another was chosen
  newest_ = state;
  plots_->add(state);
  views_->camera().showState(state);
}

void Panel::onLost() {
  controls_->setEnabled(false);
  banner_->setText(QString("No node answers at <b>%1</b>. Start one:<br><tt>roslaunch poinsot demo.launch</tt><br>(A "
                           "recording plays without a node, and cannot be controlled.)")
                       .arg(link_->node().toHtmlEscaped()));
  banner_->show();
  showText(node_, link_->node());
  notice_->forgetNode();
  clear();
}

void Panel::refresh() {
  views_->refresh();
  reset_guard_->refillDisplays();
  if (const auto eye = eyeInWorld(*vis_manager_)) link_->setEye(*eye);
  notice_->refresh();
  const QString body = isVisible() ? method_->body() : QString();
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
