#pragma once

#include <poinsot/NodeStatus.h>

#include <QElapsedTimer>
#include <QString>
#include <QStringList>

namespace poinsot::rviz_panel {

/** Returns whether another scene, method or spin, or a reset, is being worked out; a seek changes none of these. */
bool isChanging(const NodeStatus& status);

/** Returns whether the node is stepping to another time. */
bool isSeeking(const NodeStatus& status);

/** Returns what is being worked out, such as "method rk4 of wing and seek"; empty when nothing is. */
QString activityText(const NodeStatus& status);

/** Returns the status of the body of that name; null where there is none. */
const BodyStatus* bodyNamed(const NodeStatus& status, const QString& name);

/** Returns the names of all bodies. */
QStringList bodyNames(const NodeStatus& status);

/** Keeps what the user has just chosen from being overwritten by a status from before that. */
class HoldOff {
 public:
  void begin() { since_.start(); }
  void end() { since_.invalidate(); }
  /** Returns whether it was begun less than 0.7 s ago, or has not ended because what was chosen is being worked out. */
  bool holds(bool at_work = false);

 private:
  QElapsedTimer since_;
};

}  // namespace poinsot::rviz_panel
