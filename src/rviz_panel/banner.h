#pragma once

#include <QLabel>

namespace poinsot::rviz_panel {

class NodeLink;

/** How far the node can be controlled. */
enum class Reach {
  controllable,
  waits_for_clock,  ///< the node waits for the /clock of another program
  recording,        ///< bodies are heard, but no node
  nobody
};

/** Returns what the banner says of that; empty where nothing need be said. @param node its name. */
QString bannerText(Reach reach, const QString& node);

/** Tells at the top of the panel what keeps the node from being controlled; hidden where nothing does. */
class Banner : public QLabel {
 public:
  explicit Banner(const NodeLink* link);

  /** @param waits whether the node waits for the /clock of another program, as its last status said. */
  void showStatus(bool waits);
  /** Shows what holds now. */
  void refresh();

 private:
  Reach reach() const;

  const NodeLink* link_;
  bool waits_for_clock_ = false;
};

}  // namespace poinsot::rviz_panel
