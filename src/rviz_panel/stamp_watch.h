#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

namespace poinsot::rviz_panel {

/** Notices that a node's stamps stay the same, as they do while ROS time stands still. */
class StampWatch {
 public:
  /**
   * Takes what the node says now.
   * @param stamp of its last tick [ns]
   * @param rate of its ticks [Hz]
   * @param now by the wall's clock [s]
   */
  void add(std::int64_t stamp, double rate, double now) {
    if (stamp_ != stamp) since_ = now;
    stamp_ = stamp;
    stands_still_ = now - since_ > std::max(kLeast, kMostTicks / rate);
  }
  void clear() { *this = StampWatch(); }
  bool standsStill() const { return stands_still_; }

 private:
  static constexpr double kLeast = 1;      // s
  static constexpr double kMostTicks = 3;  // that may be late

  std::optional<std::int64_t> stamp_;
  double since_ = 0;
  bool stands_still_ = false;
};

}  // namespace poinsot::rviz_panel
