#include "banner.h"

#include "node_link.h"

namespace poinsot::rviz_panel {

QString bannerText(Reach reach, const QString& node) {
  const QString name = QString("<b>%1</b>").arg(node.toHtmlEscaped());
  switch (reach) {
    case Reach::controllable:
      return {};
    case Reach::waits_for_clock:
      return name + " is waiting for <b>/clock</b>: /use_sim_time is set, but ROS time does not move on.";
    case Reach::recording:
      return QString("<b>A recording</b> is shown; nothing can be controlled.<br>No node answers at %1.").arg(name);
    case Reach::nobody:
      break;
  }
  return QString(
             "No node answers at %1. Start one:<br><tt>roslaunch poinsot demo.launch</tt><br>(A recording plays "
             "without a node, and cannot be controlled.)")
      .arg(name);
}

Banner::Banner(const NodeLink* link) : link_(link) {
  setObjectName("banner");
  setWordWrap(true);
  setTextInteractionFlags(Qt::TextSelectableByMouse);
  setMargin(8);
  setStyleSheet("QLabel { background: #fff3d6; color: #5a3a00; border-bottom: 1px solid #e69f00; }");
}

void Banner::showStatus(bool waits) {
  waits_for_clock_ = waits;
  refresh();
}

void Banner::refresh() {
  const QString words = bannerText(reach(), link_->node());
  if (text() != words) setText(words);
  setVisible(!words.isEmpty());
}

Reach Banner::reach() const {
  if (link_->alive()) return waits_for_clock_ ? Reach::waits_for_clock : Reach::controllable;
  return link_->hearsRecording() ? Reach::recording : Reach::nobody;
}

}  // namespace poinsot::rviz_panel
