#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "poinsot/core/effects/text.h"
#include "poinsot/core/torques.h"

namespace poinsot {

/** Torques that are switched on and off, as thrusters are. Steps end at the switching times. */
struct TorqueSchedule {
  static constexpr const char* kName = "torque_schedule";

  struct Segment {
    double from, to;  ///< from ≤ t < to [s], from < to; segments do not overlap
    Axes axes;
    Eigen::Vector3d torque;  ///< [N·m]
  };
  std::vector<Segment> segments;

  std::string text() const {
    std::string out;
    for (const Segment& s : segments) {
      out += (out.empty() ? "" : "; ") + std::string("from ") + effects::text(s.from) + ", to " + effects::text(s.to) +
             ", frame " + (s.axes == Axes::body ? "body" : "world") + ", torque " + effects::text(s.torque);
    }
    return out;
  }
  void addTo(Torques& torques) const {
    for (const Segment& s : segments) torques.addBetween(s.from, s.to, s.axes, s.torque);
  }
};

}  // namespace poinsot
