#pragma once

#include <Eigen/Core>
#include <QPolygonF>
#include <deque>

namespace poinsot::rviz_panel {

/** One state of a body, as far as it is plotted. */
struct Sample {
  double stamp = 0;                ///< s of ROS time
  double time = 0;                 ///< simulation time [s]
  unsigned segment = 0;            ///< motion is continuous only inside one
  Eigen::Vector3d omega{0, 0, 0};  ///< rad/s, body axes
  double energy_drift = 0;         ///< relative
  double momentum_drift = 0;       ///< relative
  double attitude_error = 0;       ///< rad; NaN where there is no closed form
};

/**
 * The newest part of a motion, of bounded length and size: `window` seconds of stamps in which t moved (a pause does
 * not push it out), at most `capacity` samples (what comes faster is left out). A new segment, or a stamp that goes
 * back, begins anew.
 */
class History {
 public:
  History(double window, int capacity) : window_(window), spacing_(window / capacity) {}

  void add(const Sample& sample);
  void clear();

  bool empty() const { return kept_.empty(); }
  std::size_t size() const { return kept_.size(); }
  /** Oldest first. The last one is the newest sample added. */
  const Sample& operator[](std::size_t i) const { return kept_[i].sample; }
  const Sample& newest() const { return kept_.back().sample; }

 private:
  struct Kept {
    Sample sample;
    double played;  ///< s of stamps in which t moved, up to this sample
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
