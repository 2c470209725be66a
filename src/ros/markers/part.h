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
 * One thing that is drawn of a body: some markers, with namespaces and ids that no other part uses. It overrides what
 * it has to say. What moves is stamped for it.
 */
class Part {
 public:
  virtual ~Part() = default;

  /** What stands still. */
  virtual void appendStatic(const Subject& /*subject*/, Canvas& /*canvas*/) const {}

  /** What moves, at one tick. */
  virtual void appendMoving(const Subject& /*subject*/, const Now& /*now*/, Canvas& /*canvas*/) {}

  /** What tells figures. */
  virtual void appendFigures(const Subject& /*subject*/, const session::Tick& /*tick*/, const Figures& /*figures*/,
                             Canvas& /*canvas*/) {}

  /** Forgets where the body was: nobody looked, or the motion jumped. */
  virtual void clearTrail() {}

  /** The next markers hold also what is sent only now and then. */
  virtual void sendAllNext() {}
};

/** As std::printf formats it. */
std::string formatted(const char* format, double value);

/** When what is sent only now and then is due. Stamps may begin anew. */
class Cadence {
 public:
  explicit Cadence(session::Nanoseconds pause) : pause_(pause) {}

  /** Whether it is to be sent now, by its pause or because it shall be; then the next one is due a pause later. */
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

/** Whether a size has changed so much since it was drawn that it shows. */
inline bool differs(double size, double drawn) {
  constexpr double kVisible = 0.002;  // relative: 2 mm of a picture
  return std::abs(size - drawn) > kVisible * drawn;
}

}  // namespace poinsot::node::parts
