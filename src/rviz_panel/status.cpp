#include "status.h"

#include <algorithm>

namespace poinsot::rviz_panel {
namespace {

constexpr int kHoldOff = 700;  // ms

QString textOf(const Activity& activity) {
  const QString body = QString::fromStdString(activity.body);
  switch (activity.kind) {
    case Activity::LOAD_SCENE:
      return "scene " + QString::fromStdString(activity.scene);
    case Activity::SET_METHOD:
      return "method " + QString::fromStdString(activity.method) + " of " + body;
    case Activity::SET_SPIN:
      return "spin of " + body;
    case Activity::RESET:
      return "reset";
    case Activity::SEEK:
      return "seek";
    default:
      return "a change";
  }
}

}  // namespace

bool isChanging(const NodeStatus& status) {
  return std::any_of(status.activities.begin(), status.activities.end(),
                     [](const Activity& activity) { return activity.kind != Activity::SEEK; });
}

bool isSeeking(const NodeStatus& status) {
  return std::any_of(status.activities.begin(), status.activities.end(),
                     [](const Activity& activity) { return activity.kind == Activity::SEEK; });
}

QString activityText(const NodeStatus& status) {
  QStringList texts;
  for (const Activity& activity : status.activities) texts << textOf(activity);
  texts.removeDuplicates();
  return texts.join(" and ");
}

const BodyStatus* bodyNamed(const NodeStatus& status, const QString& name) {
  for (const BodyStatus& body : status.bodies) {
    if (QString::fromStdString(body.name) == name) return &body;
  }
  return nullptr;
}

QStringList bodyNames(const NodeStatus& status) {
  QStringList out;
  for (const BodyStatus& body : status.bodies) out << QString::fromStdString(body.name);
  return out;
}

bool HoldOff::holds(bool at_work) {
  if (since_.isValid() && since_.hasExpired(kHoldOff) && !at_work) since_.invalidate();
  return since_.isValid();
}

}  // namespace poinsot::rviz_panel
