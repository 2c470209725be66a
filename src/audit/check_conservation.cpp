#include <algorithm>
#include <cmath>

#include "checks.h"

namespace poinsot::audit {
namespace {

using Eigen::Vector3d;

/** Returns in words which limit a drift exceeds: `allowed` by the method, or the ceiling for all methods. */
std::string tooMuch(const std::string& what, double figure, double allowed, double ceiling, const Bounds& bounds,
                    double span) {
  const std::string drift = text("%s by %.3g in %.6g s", what.c_str(), figure, span), method = bounds.methodAndStep();
  if (figure > ceiling && figure <= allowed) {
    return drift + ": " + method + text(" is too coarse for ground truth (at most %g)", ceiling);
  }
  return drift + ", more than " + method + text(" allows (%.3g)", allowed) +
         (figure > ceiling ? text(" and more than ground truth may (%g)", ceiling) : "");
}

/** Returns E and L of a free body, worked out from attitude, omega_body and the tensor, not taken from other fields. */
std::vector<Constant> constantsOfFreeBody(const Segment& segment) {
  const RigidBody& body = *segment.body;
  const auto energy = [&](const State& s) { return Vector3d(body.energy(segment.phase(s)), 0, 0); };
  const auto momentum = [&](const State& s) { return body.momentum(segment.phase(s)); };
  const auto length = [momentum](const State& s) { return Vector3d(momentum(s).norm(), 0, 0); };
  const auto energyMay = [&](const State& s) { return segment.bounds.energy(s); };
  const auto momentumMay = [&](const State& s) { return segment.bounds.momentum(s); };
  const double e = energy(segment.first()).x(), l = length(segment.first()).x();
  return {{"E conserved", "energy drifts", energy, e, energyMay},
          {"|L| conserved", "|L| drifts", length, l, momentumMay},
          {"L conserved", "L changes", momentum, l, momentumMay}};
}

void judgeConstant(const Segment& segment, const Constant& constant, double ceiling, Judge& judge) {
  const State& first = segment.first();
  const Vector3d start = constant.value(first);
  for (const State* s : segment.states) {
    const Vector3d now = constant.value(*s);
    if (!(constant.scale > 0)) {
      judge.compare((now - start).norm(), 0, seconds(s->stamp), [] { return "a body at rest begins to turn"; });
      continue;
    }
    const double off = (now - start).norm() / constant.scale;
    const double allowed = constant.allowed(first) + constant.allowed(*s);
    judge.compare(off, std::min(allowed, ceiling), seconds(s->stamp), [&] {
      const double angle = std::atan2(now.cross(start).norm(), now.dot(start));
      const bool turns = segment.description->isFree() && angle > 2 * std::abs(now.norm() / start.norm() - 1);
      return tooMuch(turns ? "L turns (in rad)" : constant.words, turns ? angle : off, allowed, ceiling, segment.bounds,
                     s->time - first.time);
    });
  }
}

void judgeConstants(const Evidence& evidence, std::vector<Check>& checks) {
  std::vector<std::pair<std::string, Judge>> judges;
  const auto judgeOf = [&](const std::string& name) -> Judge& {
    for (auto& [known, judge] : judges) {
      if (known == name) return judge;
    }
    return judges.emplace_back(name, Judge(name, evidence.body.key)).second;
  };
  const double ceiling = evidence.options.drift;
  bool unknown = false;
  for (const Segment& segment : evidence.segments) {
    const bool free = segment.description->isFree();
    for (const Constant& constant : free ? constantsOfFreeBody(segment) : constantsUnderTorques(segment)) {
      judgeConstant(segment, constant, ceiling, judgeOf(constant.name));
    }
    unknown = unknown || (free && !segment.bounds.unknown().empty());
    if (!free && segment.body->effects().onlyDissipates()) judgeFall(segment, ceiling, judgeOf("E never rises"));
  }
  for (auto& [name, judge] : judges) {
    if (unknown) judge.note(text("the method is unknown here: drifts were held to the ceiling of %g only", ceiling));
    checks.push_back(judge.verdict());
  }
}

/** Checks that attitude_error is nowhere larger than the method allows; NaN stands for no figure. */
void judgeAttitudeError(const Evidence& evidence, std::vector<Check>& checks) {
  Judge judge("attitude_error", evidence.body.key, "rad");
  for (const Segment& segment : evidence.segments) {
    const Bounds& bounds = segment.bounds;
    const bool free = segment.description->isFree();
    for (const State* s : segment.states) {
      const double at = seconds(s->stamp), error = s->attitude_error;
      if (!free) {
        judge.compare(std::isnan(error) ? 0 : 1, 0, at, [error] {
          return text("attitude_error: expected NaN under torques, without a closed form, got %.3g rad", error);
        });
      } else if (std::isnan(error)) {
        judge.compare(bounds.exact() ? 1 : 0, 0, at,
                      [] { return "attitude_error is NaN under the closed form itself"; });
      } else if (error < 0) {
        judge.compare(-error, 0, at,
                      [error] { return text("attitude_error: expected at least 0, got %.3g rad", error); });
      } else {
        const double allowed = bounds.attitude(*s);
        judge.compare(error, allowed, at, [&] {
          return text("attitude_error says %.3g rad at t = %.6g s, more than method %s allows (%.3g)", error, s->time,
                      bounds.method().c_str(), allowed);
        });
      }
    }
  }
  checks.push_back(judge.verdict());
}

void judgeDriftFields(const Evidence& evidence, std::vector<Check>& checks) {
  Judge judge("energy_drift and momentum_drift", evidence.body.key);
  for (const Segment& segment : evidence.segments) {
    const Inertia& inertia = segment.body->inertia();
    const auto momentum = [&](const State& s) { return segment.body->momentum(segment.phase(s)); };
    const State& first = segment.first();
    const double e0 = inertia.energy(first.omega_body), at0 = seconds(first.stamp);
    const Vector3d l0 = momentum(first);
    if (segment.begins_here) {
      judge.compare(std::abs(first.energy_drift) + first.momentum_drift, 1e-14, at0,
                    [] { return "a segment's first message has a drift that is not zero"; });
    }
    // Of a segment that was recorded from its middle only differences are known: E_start is E_first/(1 + drift_first).
    const bool from_start = first.energy_drift == 0 && first.momentum_drift == 0;
    const double e_offset = first.energy_drift, l_offset = first.momentum_drift;
    if (!(e0 > 0) || !(l0.norm() > 0) || !std::isfinite(e_offset) || !std::isfinite(l_offset)) continue;
    for (const State* s : segment.states) {
      const double at = seconds(s->stamp);
      const double expected = inertia.energy(s->omega_body) / e0 * (1 + e_offset) - 1;
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
        // L at the start is unknown, and |L| there known to l_offset: only the triangle inequality can be checked.
        const double moved_most = moved * (1 + l_offset);
        judge.compare(std::max(0.0, std::abs(s->momentum_drift - l_offset) - moved_most), l_rounding, at, [&] {
          return text("momentum_drift changes by %.6g, the momenta of the messages only by %.6g",
                      s->momentum_drift - l_offset, moved);
        });
      }
    }
  }
  judge.ifNothing("the body is at rest, so that it has no relative drift");
  Check check = judge.verdict();
  if (check.count == 0 && !evidence.segments.empty()) check.passed = true;
  checks.push_back(check);
}

}  // namespace

void judgeConservation(const Evidence& evidence, std::vector<Check>& checks) {
  if (evidence.body.torquesAreRead()) {
    judgeSlugsStart(evidence, checks);
    judgeConstants(evidence, checks);
  }
  judgeDriftFields(evidence, checks);
  judgeAttitudeError(evidence, checks);
}

}  // namespace poinsot::audit
