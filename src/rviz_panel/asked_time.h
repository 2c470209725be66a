#pragma once

#include <cstdint>
#include <optional>

namespace poinsot::rviz_panel {

/**
 * Hides the time of a motion from which the user has asked to jump to another t, until the node has got there: messages
 * from before the jump would show the old t for a moment. The node counts a new segment when it jumps, so what has the
 * segment of before is hidden. A request that leads nowhere (it was refused, or lost) is given up after two seconds in
 * which the node is not seeking.
 */
class AskedTime {
 public:
  static constexpr double kPatience = 2;  ///< [s]

  /** Another t is asked for. @param now by a steady clock [s]. */
  void ask(double now) {
    before_ = newest_;
    since_ = now;
  }
  /** Hides nothing any longer. */
  void end() { before_.reset(); }

  /**
   * Takes note of a message of the node, and returns whether its t is to be hidden.
   * @param segment of the motion, as the message has it.
   * @param seeking whether the node is working its way to another t.
   */
  bool hides(std::uint32_t segment, bool seeking, double now) {
    newest_ = segment;
    if (before_ != segment) return false;
    if (seeking) since_ = now;
    if (now - since_ > kPatience) before_.reset();
    return before_.has_value();
  }

 private:
  std::optional<std::uint32_t> newest_;  ///< the segment of the newest message
  std::optional<std::uint32_t> before_;  ///< the segment that is hidden
  double since_ = 0;                     ///< when t was asked for, or the node was last seen to seek [s]
};

}  // namespace poinsot::rviz_panel
