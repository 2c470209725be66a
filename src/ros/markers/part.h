#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "markers/subject.h"
#include "poinsot/core/motion.h"
#include "poinsot/ros/markers/body_picture.h"
#include "poinsot/ros/markers/marker_tracker.h"
#include "poinsot/session/tick.h"

namespace poinsot::node::parts {

using visualization_msgs::Marker;

/** The body at one tick. */
struct Now {
  const session::Tick& tick;
  const Motion& motion;
  const MotionState& state;
};

/**
 * One thing that is drawn of a body: some markers, with namespaces and ids that no other part uses. A part overrides
 * the functions that it needs. What moves is stamped for it.
 */
class Part {
 public:
  virtual ~Part() = default;

  /** Appends what stands still. */
  virtual void appendStatic(const Subject& /*subject*/, Canvas& /*canvas*/) const {}

  /** Appends what moves, at one tick. */
  virtual void appendMoving(const Subject& /*subject*/, const Now& /*now*/, Canvas& /*canvas*/) {}

  /** Appends what shows figures. */
  virtual void appendFigures(const Subject& /*subject*/, const session::Tick& /*tick*/, const Figures& /*figures*/,
                             Canvas& /*canvas*/) {}

  /** Forgets where the body was: there was no viewer, or the motion jumped. */
  virtual void clearTrail() {}

  /** Has the next markers hold also what is sent only now and then. */
  virtual void sendAllNext() {}
};

/** Returns the value as std::printf formats it. */
std::string formatted(const char* format, double value);

/** Says when what is sent only now and then is due. Stamps may go back. */
class Cadence {
 public:
  explicit Cadence(session::Nanoseconds pause) : pause_(pause) {}

  /** Returns whether it is to be sent now: after its pause, or `anyway`. Then the next is due a pause later. */
  bool due(session::Nanoseconds now, bool anyway = false) {
    const bool out = anyway || !sent_ || now < *sent_ || now >= *sent_ + pause_;
    if (out) sent_ = now;
    return out;
  }
  void reset() { sent_.reset(); }  ///< it is due at once

 private:
  session::Nanoseconds pause_;
  std::optional<session::Nanoseconds> sent_;
};

/** Returns whether a size has visibly changed since it was drawn. */
inline bool differs(double size, double drawn) {
  constexpr double kVisible = 0.002;  // relative: 2 mm of a picture
  return std::abs(size - drawn) > kVisible * drawn;
}

}  // namespace poinsot::node::parts
