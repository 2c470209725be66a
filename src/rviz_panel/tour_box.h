#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <functional>
#include <memory>

#include "tour.h"

namespace poinsot::rviz_panel {

class NodeLink;

/** A box that leads through the tour: what the card says, and buttons to the next card and back. */
class TourBox : public QFrame {
 public:
  /** @param look shows a saved view of RViz. */
  TourBox(NodeLink* link, std::function<void(const QString& view)> look);

  /** Opens and closes the box; to be placed elsewhere. */
  QToolButton* button() { return button_; }

  void showStatus(const NodeStatus& status);
  /** What was asked for is refused, or the node is gone. */
  void fail();

 private:
  void open(bool opened);
  void go(int by);
  void act(Tour::Act act);
  void showCard();

  NodeLink* link_;
  std::function<void(const QString& view)> look_;
  std::unique_ptr<Tour> tour_;
  QToolButton* button_;
  QLabel* title_;
  QLabel* says_;
  QPushButton* back_;
  QPushButton* next_;
};

}  // namespace poinsot::rviz_panel
