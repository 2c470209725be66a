#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "poinsot/core/effects/text.h"
#include "poinsot/core/torques.h"

namespace poinsot {

/** Torques that are switched on and off, as thrusters are. Steps end at the switching times. */
struct TorqueSchedule {
  /** The type's name in scene files. */
  static constexpr const char* kName = "torque_schedule";

  /** One torque and when it acts. */
  struct Segment {
    double from;             ///< it acts for from ≤ t < to [s]
    double to;               ///< [s], later than `from`; the scene reader refuses segments that overlap
    Axes axes;               ///< in which the torque is constant
    Eigen::Vector3d torque;  ///< [N·m]
  };
  std::vector<Segment> segments;  ///< in any order

  /** Returns all keys and values as in scene files, with 17 significant digits. */
  std::string text() const {
    std::string out;
    for (const Segment& s : segments) {
      out += (out.empty() ? "" : "; ") + std::string("from ") + effects::text(s.from) + ", to " + effects::text(s.to) +
             ", frame " + (s.axes == Axes::body ? "body" : "world") + ", torque " + effects::text(s.torque);
    }
    return out;
  }
  /** Adds its torque to the sum. Throws std::invalid_argument for a torque that is not finite and for from ≥ to. */
  void addTo(Torques& torques) const {
    for (const Segment& s : segments) torques.addBetween(s.from, s.to, s.axes, s.torque);
  }
};

}  // namespace poinsot
