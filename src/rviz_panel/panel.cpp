#include "panel.h"

#include <rviz/config.h>
#include <rviz/visualization_manager.h>
#include <pluginlib/class_list_macros.hpp>

#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QVBoxLayout>

#include "colours.h"
#include "method_choice.h"
#include "plots.h"
#include "read_outs.h"
#include "reset_guard.h"
#include "scene_choice.h"
#include "transport.h"
#include "view_choice.h"
#include "viewpoint.h"
#include "widgets.h"

namespace poinsot::rviz_panel {
namespace {

constexpr int kRefreshEvery = 100;  // ms
constexpr int kGoodNewsFor = 5000;  // ms
constexpr int kTroubleFor = 15000;  // ms
constexpr int kLongWork = 400;      // ms: good news give way to what takes longer
constexpr int kWidth = 330;

QFrame* line() {
  auto* const out = new QFrame;
  out->setFrameShape(QFrame::HLine);
  out->setFrameShadow(QFrame::Sunken);
  return out;
}

}  // namespace

Panel::Panel(QWidget* parent) : rviz::Panel(parent), link_(new NodeLink(this)) {
  build();
  wire();
  onLost();
}

void Panel::build() {
  setObjectName("poinsot_panel");
  auto* const outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->setSpacing(0);

  banner_ = new QLabel;
  banner_->setObjectName("banner");
  banner_->setWordWrap(true);
  banner_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  banner_->setMargin(8);
  banner_->setStyleSheet("QLabel { background: #fff3d6; color: #5a3a00; border-bottom: 1px solid #e69f00; }");
  outer->addWidget(banner_);

  auto* const scroll = new QScrollArea;
  scroll->setObjectName("scroll");
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* const page = new QWidget;
  auto* const layout = new QVBoxLayout(page);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(6);

  controls_ = new QWidget;
  controls_->setObjectName("controls");
  auto* const parts = new QVBoxLayout(controls_);
  parts->setContentsMargins(0, 0, 0, 0);
  parts->setSpacing(6);
  scene_ = new SceneChoice;
  transport_ = new Transport;
  method_ = new MethodChoice;
  read_outs_ = new ReadOuts;
  plots_ = new Plots;
  parts->addWidget(scene_);
  parts->addWidget(line());
  parts->addWidget(transport_);
  parts->addWidget(line());
  parts->addWidget(method_);
  parts->addWidget(line());
  parts->addWidget(read_outs_);
  parts->addWidget(plots_);

  views_ = new ViewChoice;
  auto* const node_row = new QHBoxLayout;
  auto* const node_label = new QLabel("&node");
  node_ = new QLineEdit;
  describe(node_, "node", "The name of the Poinsot node to lead; press Enter. Kept in the .rviz file.");
  node_label->setBuddy(node_);
  node_row->addWidget(node_label);
  node_row->addWidget(node_, 1);

  layout->addWidget(controls_);
  layout->addWidget(line());
  node_row->addWidget(views_->light(), 0);
  layout->addWidget(views_);
  layout->addLayout(node_row);
  layout->addStretch();
  scroll->setWidget(page);
  outer->addWidget(scroll, 1);

  notice_ = new QLabel;
  notice_->setObjectName("notice");
  notice_->setWordWrap(true);
  notice_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  notice_->setMargin(6);
  outer->addWidget(line());
  outer->addWidget(notice_);
  setMinimumWidth(260);
  showNode();
}

void Panel::wire() {
  connect(link_, &NodeLink::statusReceived, this, &Panel::onStatus);
  connect(link_, &NodeLink::stateReceived, this, &Panel::onState);
  connect(link_, &NodeLink::descriptionReceived, plots_, &Plots::setPrincipalAxes);
  connect(link_, &NodeLink::descriptionReceived, views_, &ViewChoice::showDescription);
  connect(link_, &NodeLink::lost, this, &Panel::onLost);
  connect(link_, &NodeLink::found, this, [this] {
    controls_->setEnabled(true);
    banner_->hide();
    follow();  // the body's name need not have changed
    if (viewpoint_) viewpoint_->repeat();
  });
  connect(link_, &NodeLink::done, this, [this](const QString& message) { say(message, false); });
  connect(link_, &NodeLink::refused, this, [this](const QString& message) { say(message, true); });

  connect(scene_, &SceneChoice::sceneAsked, link_, &NodeLink::loadScene);
  connect(transport_, &Transport::pauseAsked, link_, &NodeLink::setPaused);
  connect(transport_, &Transport::stepAsked, link_, &NodeLink::step);
  connect(transport_, &Transport::resetAsked, link_, &NodeLink::reset);
  connect(transport_, &Transport::speedAsked, link_, &NodeLink::setSpeed);
  connect(transport_, &Transport::seekAsked, link_, &NodeLink::seek);
  connect(transport_, &Transport::refused, this, [this](const QString& message) { say(message, true); });
  connect(transport_, &Transport::spanChanged, this, &Panel::configChanged);
  connect(method_, &MethodChoice::methodAsked, link_, &NodeLink::setMethod);
  connect(method_, &MethodChoice::refused, this, [this](const QString& message) { say(message, true); });
  connect(method_, &MethodChoice::bodyChanged, this, &Panel::follow);
  connect(node_, &QLineEdit::editingFinished, this, [this] {
    if (!node_->isModified()) return;
    node_->setModified(false);
    const QString before = link_->node();
    link_->setNode(node_->text());
    showNode();
    if (link_->node() != before) Q_EMIT configChanged();
  });

  connect(&timer_, &QTimer::timeout, this, &Panel::refresh);
  timer_.start(kRefreshEvery);
}

void Panel::onInitialize() {
  views_->setManager(vis_manager_);
  new ResetGuard(vis_manager_, this);
  viewpoint_ = new Viewpoint(vis_manager_, this);
  connect(viewpoint_, &Viewpoint::moved, link_, &NodeLink::setViewpoint);
}

void Panel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString node;
  if (config.mapGetString("Node", &node)) link_->setNode(node);
  float span = 0;
  bool both_sides = false;
  config.mapGetBool("Negative Times", &both_sides);
  config.mapGetFloat("Time Span", &span);
  transport_->setSpan(span, both_sides);
  views_->load(config);
  showNode();
}

void Panel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Node", link_->node());
  config.mapSetValue("Time Span", transport_->span());
  config.mapSetValue("Negative Times", transport_->bothSides());
  views_->save(config);
}

QSize Panel::sizeHint() const {
  return {kWidth, 800};
}

void Panel::showEvent(QShowEvent* event) {
  rviz::Panel::showEvent(event);
  follow();
}

void Panel::hideEvent(QHideEvent* event) {
  rviz::Panel::hideEvent(event);
  follow();
}

void Panel::follow() {
  newest_.reset();
  plots_->clear();
  read_outs_->clear();
  link_->setBody(isVisible() ? method_->body() : QString());
}

void Panel::onStatus(const NodeStatus& status) {
  const QString scene = QString::fromStdString(status.scene);
  if (scene_name_ && *scene_name_ != scene) {
    views_->loadViewsOf(scene);
    if (!said_trouble_) said_.clear();  // that it was being made ready
  }
  scene_name_ = scene;
  stamps_.add(static_cast<std::int64_t>(status.header.stamp.toNSec()), status.rate, ros::SteadyTime::now().toSec());
  busy_ = QString::fromStdString(status.busy);
  if (busy_.isEmpty()) since_idle_.start();
  const QString refused = QString::fromStdString(status.refused);
  if (refused != refused_) {
    refused_ = refused;
    if (!refused_.isEmpty()) said_.clear();  // newer
  }
  scene_->showStatus(status);
  transport_->showStatus(status);
  method_->showStatus(status);
  read_outs_->showStatus(status, method_->body());
}

void Panel::onState(const BodyState& state) {
  if (QString::fromStdString(state.body) != method_->body()) return;  // on its way when another was chosen
  newest_ = state;
  plots_->add(state);
  views_->showState(state);
}

void Panel::onLost() {
  controls_->setEnabled(false);
  banner_->setText(QString("No node answers at <b>%1</b>. Start one:<br><tt>roslaunch poinsot demo.launch</tt><br>(A "
                           "recording plays without a node, and there is nothing to lead.)")
                       .arg(link_->node().toHtmlEscaped()));
  banner_->show();
  busy_.clear();
  refused_.clear();
  stamps_.clear();
  newest_.reset();
  read_outs_->clear();
  plots_->clear();
}

void Panel::refresh() {
  showNotice();
  if (!isVisible()) return;
  if (newest_) {
    read_outs_->showState(*newest_);
    transport_->showTime(newest_->time);
    newest_.reset();
  }
  plots_->refresh();
}

void Panel::say(const QString& message, bool trouble) {
  said_ = message;
  said_trouble_ = trouble;
  since_said_.start();
  showNotice();
}

void Panel::showNotice() {
  if (!said_.isEmpty() && since_said_.hasExpired(said_trouble_ ? kTroubleFor : kGoodNewsFor)) said_.clear();
  QString text;
  bool trouble = false;
  const bool takes_time = !busy_.isEmpty() && since_idle_.hasExpired(kLongWork);
  if (!said_.isEmpty() && !(takes_time && !said_trouble_)) {
    text = said_;
    trouble = said_trouble_;
  } else if (link_->alive() && link_->waiting()) {
    text = "Waiting for the node to answer …";
  } else if (!busy_.isEmpty()) {
    text = "Working out: " + busy_ + " …";
  } else if (!refused_.isEmpty()) {
    text = refused_;
    trouble = true;
  } else if (link_->alive() && stamps_.standsStill()) {
    text = "No new tick: ROS time stands still, or hardly moves.";
    trouble = true;
  } else {
    text = link_->alive() ? "Ready." : "Looking for the node …";
  }
  if (notice_->text() == text) return;
  notice_->setText(text);
  QPalette palette = this->palette();
  if (trouble) palette.setColor(QPalette::WindowText, colours::kTrouble);
  notice_->setPalette(palette);
}

void Panel::showNode() {
  showText(node_, link_->node());
  if (!link_->alive()) onLost();
}

}  // namespace poinsot::rviz_panel

PLUGINLIB_EXPORT_CLASS(poinsot::rviz_panel::Panel, rviz::Panel)
