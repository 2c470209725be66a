#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace poinsot::view {

/**
 * The last stretch of a path, to be drawn behind a moving point. Its last point is always the newest one added.
 *
 * Only the constructor allocates. The caller clears it when the motion jumps.
 */
class Trail {
 public:
  /**
   * @param capacity most points kept, at least 2.
   * @param length of the path behind the newest point [the points' unit]; points further back are dropped.
   * @param spacing least distance between kept points [the points' unit], but for the newest.
   */
  Trail(std::size_t capacity, double length, double spacing);

  /** Adds a point. Ignored unless finite. */
  void add(const Eigen::Vector3d& point);

  void clear();

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  /** Returns point i, the oldest first, i < size(). */
  const Eigen::Vector3d& operator[](std::size_t i) const { return entry(i).point; }

 private:
  struct Entry {
    double travelled;  ///< path length from the first point to this one
    Eigen::Vector3d point;
  };

  const Entry& entry(std::size_t i) const { return ring_[(first_ + i) % ring_.size()]; }
  void dropOldest();

  std::vector<Entry> ring_;
  double length_;
  double spacing_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  double travelled_ = 0;  ///< path length since clear()
};

}  // namespace poinsot::view
