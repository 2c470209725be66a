#pragma once

#include <poinsot/BodyState.h>

#include <QPolygonF>
#include <deque>

namespace poinsot::rviz_panel {

/**
 * The newest part of a motion, of bounded length and size: `window` seconds of stamps in which t moved (a pause does
 * not push it out), at most `capacity` states (what comes faster is left out). A new segment, or a stamp that goes
 * back, begins anew.
 */
class History {
 public:
  History(double window, int capacity) : window_(window), spacing_(window / capacity) {}

  void add(const BodyState& state);
  void clear();

  bool empty() const { return kept_.empty(); }
  std::size_t size() const { return kept_.size(); }
  /** Oldest first. The last one is the newest state added. */
  const BodyState& operator[](std::size_t i) const { return kept_[i].state; }
  const BodyState& newest() const { return kept_.back().state; }

 private:
  struct Kept {
    BodyState state;
    double played;  ///< s of stamps in which t moved, up to this state
  };

  double window_;
  double spacing_;
  double played_ = 0;
  double last_stamp_ = 0;
  std::deque<Kept> kept_;
};

/**
 * At most 2·columns + 1 of the points, in their order, that look the same when drawn that many columns wide: of each
 * run of neighbours the lowest and the highest, and the last point of all. All of them where they are no more than
 * that.
 */
QPolygonF thinned(const QPolygonF& points, int columns);

}  // namespace poinsot::rviz_panel
