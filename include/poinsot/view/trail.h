#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace poinsot::view {

/**
 * The last stretch of a path, for drawing behind a moving point. Its last point is always the newest one added.
 *
 * Allocates on construction only. A point's age is the simulation time played since it was added, counted forwards and
 * backwards alike, so that a trail looks the same in either play direction; the caller clears it at a jump.
 */
class Trail {
 public:
  /**
   * @param capacity most points kept, at least 2; beyond it the oldest goes.
   * @param duration age at which a point is dropped [s of simulation time].
   * @param spacing closest distance between kept points [the points' unit]; the newest is exempt.
   */
  Trail(std::size_t capacity, double duration, double spacing);

  /** Adds a point at simulation time t [s]. Ignored unless both are finite. */
  void add(double time, const Eigen::Vector3d& point);

  void clear();

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  /** Point i, the oldest first, i < size(). */
  const Eigen::Vector3d& operator[](std::size_t i) const { return entry(i).point; }

 private:
  struct Entry {
    double played;  ///< simulation time played when the point was added [s]
    Eigen::Vector3d point;
  };

  const Entry& entry(std::size_t i) const { return ring_[(first_ + i) % ring_.size()]; }
  void dropOldest();

  std::vector<Entry> ring_;
  double duration_;
  double spacing_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  double played_ = 0;     ///< Σ|Δt| since clear()
  double last_time_ = 0;  ///< of the newest point
};

}  // namespace poinsot::view
