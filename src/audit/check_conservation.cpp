#include <algorithm>
#include <cmath>
#include <optional>

#include "poinsot/audit/checks.h"
#include "poinsot/audit/free_motion.h"
#include "poinsot/audit/method_bounds.h"

namespace poinsot::audit {
namespace {

/** The usable states of one segment, in order, and what describes them. */
struct Segment {
  std::vector<const State*> states;
  const Description* description;
  bool begins_here;  ///< its first message is in the recording
};

std::vector<Segment> segmentsOf(const Body& body) {
  std::vector<Segment> segments;
  for (std::size_t begin = 0, end; begin < body.states.size(); begin = end) {
    Segment segment;
    for (end = begin; end < body.states.size() && body.states[end].segment == body.states[begin].segment; ++end) {
      if (body.states[end].flaw.empty()) segment.states.push_back(&body.states[end]);
    }
    // Drifts refer to the first message: where that cannot be used, the segment counts as joined in its middle.
    segment.begins_here = begin > 0 && body.states[begin].flaw.empty();
    if (segment.states.empty()) continue;
    segment.description = body.descriptionAt(segment.states.back()->stamp);
    segments.push_back(segment);
  }
  return segments;
}

/** E and L from attitude, omega_body and the tensor: no other field is believed. */
double energyOf(const Inertia& inertia, const State& s) {
  return inertia.energy(s.omega_body);
}
Eigen::Vector3d momentumOf(const Inertia& inertia, const State& s) {
  return s.attitude * (inertia.tensor * s.omega_body);
}

std::string tooMuch(const char* what, double figure, double allowed, double ceiling, const MethodBounds& bounds,
                    double span) {
  const std::string drift = text("%s by %.3g in %.6g s", what, figure, span);
  const std::string method = text("method %s%s", bounds.method().c_str(),
                                  bounds.step() > 0 ? text(" at step %g s", bounds.step()).c_str() : "");
  if (figure > ceiling) {
    if (figure <= allowed) return drift + ": " + method + text(" is too coarse for ground truth (at most %g)", ceiling);
    return drift +
           text(", more than %s allows (%.3g) and more than ground truth may (%g)", method.c_str(), allowed, ceiling);
  }
  return drift + text(", more than %s allows (%.3g)", method.c_str(), allowed);
}

void judgeFree(const Evidence& evidence, const std::vector<Segment>& segments, std::vector<Check>& checks) {
  const std::string& key = evidence.body.key;
  Judge energy("E conserved", key), length("|L| conserved", key), momentum("L conserved", key);
  const double ceiling = evidence.options.drift;
  bool unknown = false;
  for (const Segment& segment : segments) {
    const Inertia inertia(segment.description->tensor);
    const MethodBounds bounds(*segment.description);
    unknown = unknown || !bounds.known();
    const State& first = *segment.states.front();
    const double e0 = energyOf(inertia, first);
    const Eigen::Vector3d l0 = momentumOf(inertia, first);
    for (const State* s : segment.states) {
      const double at = seconds(s->stamp), span = s->time - first.time;
      if (l0.norm() == 0) {
        for (Judge* judge : {&energy, &length, &momentum}) {
          judge->compare(s->omega_body.norm(), 0, at, [] { return "a free body at rest begins to turn"; });
        }
        continue;
      }
      const double e_allowed =
          bounds.energy(inertia, first.omega_body, first.time) + bounds.energy(inertia, s->omega_body, s->time);
      const double l_allowed =
          bounds.momentum(inertia, first.omega_body, first.time) + bounds.momentum(inertia, s->omega_body, s->time);
      const Eigen::Vector3d l = momentumOf(inertia, *s);
      const double de = std::abs(energyOf(inertia, *s) / e0 - 1), dl = std::abs(l.norm() / l0.norm() - 1);
      energy.compare(de, std::min(e_allowed, ceiling), at,
                     [&] { return tooMuch("energy drifts", de, e_allowed, ceiling, bounds, span); });
      length.compare(dl, std::min(l_allowed, ceiling), at,
                     [&] { return tooMuch("|L| drifts", dl, l_allowed, ceiling, bounds, span); });
      const double dv = (l - l0).norm() / l0.norm();
      momentum.compare(dv, std::min(l_allowed, ceiling), at, [&] {
        const double angle = std::atan2(l.cross(l0).norm(), l.dot(l0));
        return angle > 2 * dl ? tooMuch("L turns (in rad)", angle, l_allowed, ceiling, bounds, span)
                              : tooMuch("L changes its length", dl, l_allowed, ceiling, bounds, span);
      });
    }
  }
  for (Judge* judge : {&energy, &length, &momentum}) {
    if (unknown) judge->note(text("the method is not known here: only the ceiling of %g was asked", ceiling));
    checks.push_back(judge->verdict());
  }
}

/** How far from the closed form the messages say they are: nowhere further than the method allows; NaN says nothing. */
void judgeAttitudeError(const Evidence& evidence, const std::vector<Segment>& segments, std::vector<Check>& checks) {
  Judge judge("attitude_error", evidence.body.key, "rad");
  for (const Segment& segment : segments) {
    const Inertia inertia(segment.description->tensor);
    const MethodBounds bounds(*segment.description);
    const bool free = segment.description->isFree();
    for (const State* s : segment.states) {
      const double at = seconds(s->stamp), error = s->attitude_error;
      if (!free) {
        judge.compare(std::isnan(error) ? 0 : 1, 0, at, [error] {
          return text("attitude_error says %.3g rad, but under torques there is no closed form: NaN is wanted", error);
        });
      } else if (std::isnan(error)) {
        judge.compare(bounds.exact() ? 1 : 0, 0, at,
                      [] { return "attitude_error is NaN under the closed form itself"; });
      } else if (error < 0) {
        judge.compare(-error, 0, at, [] { return "attitude_error is an angle, and negative"; });
      } else {
        const double allowed = bounds.attitude(inertia, s->omega_body, s->time);
        judge.compare(error, allowed, at, [&] {
          return text("attitude_error says %.3g rad at t = %.6g s, more than method %s allows (%.3g)", error, s->time,
                      bounds.method().c_str(), allowed);
        });
      }
    }
  }
  checks.push_back(judge.verdict());
}

void judgeDriftFields(const Evidence& evidence, const std::vector<Segment>& segments, std::vector<Check>& checks) {
  Judge judge("energy_drift and momentum_drift", evidence.body.key);
  for (const Segment& segment : segments) {
    const Inertia inertia(segment.description->tensor);
    // With a slug L is that of both, which only momentum_world shows.
    const bool slug = segment.description->forces.slug.has_value();
    const auto momentum = [&](const State& s) { return slug ? s.momentum_world : momentumOf(inertia, s); };
    const State& first = *segment.states.front();
    const double e0 = energyOf(inertia, first), at0 = seconds(first.stamp);
    const Eigen::Vector3d l0 = momentum(first);
    if (segment.begins_here) {
      judge.compare(std::abs(first.energy_drift) + first.momentum_drift, 1e-14, at0,
                    [] { return "a segment's first message has a drift that is not zero"; });
    }
    // Recorded from its middle, a segment shows only differences: E_start is then E_first/(1 + drift_first).
    const bool from_start = first.energy_drift == 0 && first.momentum_drift == 0;
    const double e_offset = first.energy_drift, l_offset = first.momentum_drift;
    if (!(e0 > 0) || !(l0.norm() > 0) || !std::isfinite(e_offset) || !std::isfinite(l_offset)) continue;
    for (const State* s : segment.states) {
      const double at = seconds(s->stamp);
      const double expected = energyOf(inertia, *s) / e0 * (1 + e_offset) - 1;
      const double size = 1 + std::abs(expected);
      const double e_rounding = 4e-14 * inertia.conditionOfEnergy(s->omega_body) * size;
      judge.compare(std::abs(s->energy_drift - expected), e_rounding, at, [&] {
        return text("energy_drift says %.6g, the energies of the messages %.6g", s->energy_drift, expected);
      });
      const double moved = (momentum(*s) - l0).norm() / l0.norm();
      const double l_rounding = 4e-14 * inertia.conditionOfMomentum(s->omega_body) * (1 + moved);
      if (from_start) {
        judge.compare(std::abs(s->momentum_drift - moved), l_rounding, at, [&] {
          return text("momentum_drift says %.6g, the momenta of the messages %.6g", s->momentum_drift, moved);
        });
      } else {
        // Of two distances from an unknown start only the triangle's inequality is known; |L_start| to within l_offset.
        const double moved_most = moved * (1 + l_offset);
        judge.compare(std::max(0.0, std::abs(s->momentum_drift - l_offset) - moved_most), l_rounding, at, [&] {
          return text("momentum_drift changes by %.6g, the momenta of the messages only by %.6g",
                      s->momentum_drift - l_offset, moved);
        });
      }
    }
  }
  judge.ifNothing("the body is at rest: drift is relative to nothing");
  Check check = judge.verdict();
  // At rest there is no drift to be wrong about.
  if (check.count == 0 && !segments.empty()) check.passed = true;
  checks.push_back(check);
}

}  // namespace

void judgeConservation(const Evidence& evidence, std::vector<Check>& checks) {
  const std::vector<Segment> segments = segmentsOf(evidence.body);
  const auto& descriptions = evidence.body.descriptions;
  // What other bodies conserve, judgeMotion has asked.
  if (std::all_of(descriptions.begin(), descriptions.end(), [](const Description& d) { return d.isFree(); })) {
    judgeFree(evidence, segments, checks);
  }
  judgeDriftFields(evidence, segments, checks);
  judgeAttitudeError(evidence, segments, checks);
}

}  // namespace poinsot::audit
