#pragma once

#include <poinsot/NodeStatus.h>

#include <QElapsedTimer>
#include <QLabel>
#include <QString>

namespace poinsot::rviz_panel {

class NodeLink;

/**
 * The line that says what has just been done or refused, what the node is working out, or that all is well: whichever
 * matters most.
 */
class Notice : public QLabel {
 public:
  explicit Notice(const NodeLink* link);

  /** Shows what was done for a few seconds; what takes long meanwhile is shown instead. */
  void say(const QString& message) { tell(message, false); }
  /** Shows what was refused or went wrong for longer. */
  void refuse(const QString& message) { tell(message, true); }
  void showStatus(const NodeStatus& status);
  /** Another scene plays: removes the news that it was being made ready. */
  void sceneChanged();
  /** Forgets what the node told: it is gone. */
  void forgetNode();
  /** Shows what matters most now. */
  void refresh();

 private:
  void tell(const QString& message, bool trouble);
  void display(const QString& text, bool trouble);

  const NodeLink* link_;
  QString working_on_, refused_;  ///< of the last status
  bool waits_for_clock_ = false;
  QString said_;
  bool said_trouble_ = false;
  QElapsedTimer since_said_;
  QElapsedTimer since_idle_;  ///< since the node had nothing to work out
};

}  // namespace poinsot::rviz_panel
