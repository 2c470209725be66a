#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "bounds.h"
#include "poinsot/audit/recording.h"
#include "rigid_body.h"

namespace poinsot::audit {

/** The states of one segment that can be used, in the order in which they were sent, and what is known of the body. */
struct Segment {
  std::vector<const State*> states;  ///< at least one
  const Description* description;
  std::shared_ptr<const RigidBody> body;
  Bounds bounds;
  bool begins_here;                            ///< its first message is in the recording, and can be used
  double speed = 0, momentum = 0, energy = 0;  ///< the greatest in it

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

/** The segments of a body that has a description. They refer to the body. */
std::vector<Segment> segmentsOf(const Body& body);

/** Where a state leads, and how far what is said of that may be off. */
struct Followed {
  Travelled to;
  double start;                          ///< what is uncertain before it grows [rad; relative to the speed]
  double attitude;                       ///< bound of the attitude [rad]
  double omega;                          ///< bound of Ω, relative to the speed
  std::optional<Neighbours> neighbours;  ///< under torques: how what is uncertain grows
};

constexpr double kFine = 0.005;  // rad at rate(): substeps of the audit's own integration
constexpr double kFineError = kFine * kFine * kFine * kFine * kFine / 30;

/** What following a state for a duration is uncertain by, before that grows [rad; relative to the speed]. */
double uncertainty(const Segment& segment, const State& a, double duration);

/** The audit's own integration from a state. Nothing where it is too vague to judge by, or would take too long. */
std::optional<Followed> follow(const Segment& segment, const State& a, double duration);

inline double attitudeDifference(const Phase& a, const Phase& b) {
  return angleBetween(a.attitude, b.attitude);
}
inline double omegaDifference(const Phase& a, const Phase& b) {
  return (a.omega - b.omega).norm();
}

}  // namespace poinsot::audit
