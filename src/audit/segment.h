#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "bounds.h"
#include "poinsot/audit/recording.h"
#include "rigid_body.h"

namespace poinsot::audit {

/** The states of one segment that can be used, in the order in which they were sent, with the body and its bounds. */
struct Segment {
  std::vector<const State*> states;  ///< at least one
  const Description* description;
  std::shared_ptr<const RigidBody> body;
  Bounds bounds;
  bool begins_here;                            ///< whether its first message is in the recording, and can be used
  double speed = 0, momentum = 0, energy = 0;  ///< the greatest of all states

  const State& first() const { return *states.front(); }
  Phase phase(const State& s) const { return phaseOf(*body, s); }

  /** Calls `visit(a, b)` for each two states that were sent one after the other. */
  template <class Visit>
  void forPairs(const Visit& visit) const {
    for (std::size_t i = 1; i < states.size(); ++i) {
      const State &a = *states[i - 1], &b = *states[i];
      if (&b == &a + 1 && b.stamp >= a.stamp) visit(a, b);
    }
  }
};

/** Returns the segments of a body that has a description; they hold pointers to it. */
std::vector<Segment> segmentsOf(const Body& body);

/** Where a state leads, and how far that may be off. */
struct Followed {
  Travelled to;
  double start;                          ///< the uncertainty at the start [rad; relative to the speed]
  double attitude;                       ///< bound of the attitude [rad]
  double omega;                          ///< bound of Ω, relative to the speed
  std::optional<Neighbours> neighbours;  ///< under torques: the growth of that uncertainty
};

constexpr double kFine = 0.005;  // rad at rate(): substeps of the audit's own integration
constexpr double kFineError = kFine * kFine * kFine * kFine * kFine / 30;

/** Returns the uncertainty of following a state for a duration, before it grows [rad; relative to the speed]. */
double uncertainty(const Segment& segment, const State& a, double duration);

/** Integrates from a state. Returns nothing where the result is too vague to judge by, or would take too long. */
std::optional<Followed> follow(const Segment& segment, const State& a, double duration);

inline double attitudeDifference(const Phase& a, const Phase& b) {
  return angleBetween(a.attitude, b.attitude);
}
inline double omegaDifference(const Phase& a, const Phase& b) {
  return (a.omega - b.omega).norm();
}

}  // namespace poinsot::audit
