#include "notice.h"

#include <QPalette>

#include "colours.h"
#include "node_link.h"
#include "status.h"

namespace poinsot::rviz_panel {
namespace {

constexpr int kGoodNewsFor = 5000;  // ms
constexpr int kTroubleFor = 15000;  // ms
constexpr int kLongWork = 400;      // ms: good news give way to what takes longer

}  // namespace

Notice::Notice(const NodeLink* link) : link_(link) {
  setObjectName("notice");
  setWordWrap(true);
  setTextInteractionFlags(Qt::TextSelectableByMouse);
  setMargin(6);
}

void Notice::tell(const QString& message, bool trouble) {
  said_ = message;
  said_trouble_ = trouble;
  since_said_.start();
  refresh();
}

void Notice::showStatus(const NodeStatus& status) {
  working_on_ = activityText(status);
  if (working_on_.isEmpty()) since_idle_.start();
  waits_for_clock_ = status.waiting_for_clock;
  const QString refused = QString::fromStdString(status.refused);
  if (refused == refused_) return;
  refused_ = refused;
  if (!refused_.isEmpty()) said_.clear();  // newer
}

void Notice::sceneChanged() {
  if (!said_trouble_) said_.clear();
}

void Notice::forgetNode() {
  working_on_.clear();
  refused_.clear();
  waits_for_clock_ = false;
}

void Notice::refresh() {
  if (since_said_.isValid() && since_said_.hasExpired(said_trouble_ ? kTroubleFor : kGoodNewsFor)) said_.clear();
  const bool takes_long = !working_on_.isEmpty() && since_idle_.hasExpired(kLongWork);
  if (!said_.isEmpty() && (said_trouble_ || !takes_long)) {
    display(said_, said_trouble_);
  } else if (!link_->alive()) {
    display(link_->hearsRecording() ? "Showing a recording." : "Looking for the node …", false);
  } else if (link_->waiting()) {
    display("Waiting for the node to answer …", false);
  } else if (!working_on_.isEmpty()) {
    display("Working out: " + working_on_ + " …", false);
  } else if (!refused_.isEmpty()) {
    display(refused_, true);
  } else if (waits_for_clock_) {
    display("No new tick: ROS time stands still, or hardly moves.", true);
  } else {
    display("Ready.", false);
  }
}

void Notice::display(const QString& text, bool trouble) {
  if (this->text() == text) return;
  setText(text);
  QPalette palette = parentWidget()->palette();
  if (trouble) palette.setColor(QPalette::WindowText, colours::kTrouble);
  setPalette(palette);
}

}  // namespace poinsot::rviz_panel
