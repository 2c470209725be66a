#include <algorithm>
#include <cmath>

#include "checks.h"

namespace poinsot::audit {
namespace {

using Eigen::Vector3d;

/** The sum of all weights of a body. */
struct Weights {
  explicit Weights(const RigidBody& body) {
    for (const Effects::Weight& w : body.effects().weights) {
      if (gravity.isZero(0)) gravity = w.gravity.stableNormalized();
      moment += w.mass * w.gravity.norm() * w.centre.norm();
      parallel = parallel && w.gravity.cross(gravity).norm() <= 1e-14 * w.gravity.norm();
      centre += w.mass * w.gravity.dot(gravity) * w.centre;
    }
  }

  /** Returns whether the body is a symmetric top about the line from the pivot to its centre of mass. */
  bool symmetric(const Inertia& inertia) const {
    const Vector3d axis = centre.normalized(), side = axis.unitOrthogonal(), other = axis.cross(side);
    const Eigen::Matrix3d top =
        side.dot(inertia.tensor * side) * (side * side.transpose() + other * other.transpose()) +
        axis.dot(inertia.tensor * axis) * axis * axis.transpose();
    return (top - inertia.tensor).cwiseAbs().maxCoeff() <= 1e-13 * inertia.moments[2];
  }

  double moment = 0;                    ///< an upper bound of the torque [N·m]
  Vector3d gravity = Vector3d::Zero();  ///< its direction, world axes, unit
  Vector3d centre = Vector3d::Zero();   ///< Σ of weight times centre of mass [N·m], body axes
  bool parallel = true;                 ///< whether all weights pull along `gravity`
};

}  // namespace

void TorqueJudges::judge(const Segment& segment, const State& a, const State& b, const Followed& followed) {
  const RigidBody& body = *segment.body;
  const Phase start = segment.phase(a), reached = segment.phase(b), &end = followed.to.end;
  const double speed = std::max(body.speed(a.time, start), body.speed(b.time, reached));
  const double time = b.time - a.time, at = seconds(b.stamp);
  // Compares relative to a scale. The bound follows from the uncertainty of the speed and of the start.
  const auto compare = [&](Judge& judge, double off, double scale, double by_speed, const auto& difference,
                           const Judge::Explanation& explain) {
    if (!(scale > 0)) return;
    const double bound = followed.start * (by_speed * speed + followed.neighbours->growth(difference)) / scale;
    judge.compare(off / scale, bound, at, explain);
  };
  const Vector3d gained = body.momentum(reached) - body.momentum(start), &impulse = followed.to.impulse;
  const double la = body.momentum(start).norm(), lb = body.momentum(reached).norm();
  if (speed == 0) {
    at_rest_ = true;
    momentum_.compare(b.momentum_world.norm(), 0, at);
    return;
  }
  compare(
      momentum_, (gained - impulse).norm(), std::max({la, lb, impulse.norm()}),
      body.inertia().moments[2] + body.slugInertia(),
      [&](const Phase& p, const Phase& q) { return (body.momentum(p) - body.momentum(q)).norm(); },
      [&] {
        return text("L changes by %.6g kg m^2/s in %.6g s, the impulse of the torques is %.6g; they differ by %.3g",
                    gained.norm(), time, impulse.norm(), (gained - impulse).norm());
      });
  const double ea = body.energy(start), eb = body.energy(reached), work = followed.to.work;
  compare(
      energy_, std::abs(eb - ea - work), std::max(ea, eb),
      body.inertia().moments[2] * std::max(start.omega.norm(), reached.omega.norm()),
      [&](const Phase& p, const Phase& q) { return std::abs(body.energy(p) - body.energy(q)); },
      [&] {
        return text("kinetic energy changes by %.6g J in %.6g s, the work of the torques is %.6g J", eb - ea, time,
                    work);
      });
  if (!body.effects().slug) return;
  const auto slugDifference = [](const Phase& p, const Phase& q) { return (p.slug_omega - q.slug_omega).norm(); };
  compare(slug_, slugDifference(reached, end), speed, 1, slugDifference, [&] {
    return text("the slug's rate, (R'L - M omega)/J, changes by %.6g rad/s in %.6g s; its equation says %.6g rad/s",
                slugDifference(reached, start), time, slugDifference(end, start));
  });
}

void TorqueJudges::addTo(std::vector<Judge*>& out, const Evidence& evidence) {
  if (evidence.body.isFree()) return;
  out.push_back(&momentum_);
  if (!at_rest_ || energy_.count() > 0) out.push_back(&energy_);
  const auto hasSlug = [](const Segment& segment) { return segment.body->effects().slug.has_value(); };
  if (std::any_of(evidence.segments.begin(), evidence.segments.end(), hasSlug)) out.push_back(&slug_);
}

std::vector<Constant> constantsUnderTorques(const Segment& segment) {
  const RigidBody& body = *segment.body;
  const Effects& effects = body.effects();
  const double of_momentum = (body.inertia().moments[2] + body.slugInertia()) * segment.speed;
  const double of_energy = segment.momentum * segment.speed;
  std::vector<Constant> out;
  // by_error: by how much an error of 1 rad, or one of Ω as large as the speed, may change the value.
  const auto add = [&](const char* name, const std::string& what, double scale, double by_error, const auto& value) {
    out.push_back({name, what + " changes", [&segment, value](const State& s) { return value(s, segment.phase(s)); },
                   scale,
                   [&segment, factor = by_error / scale](const State& s) {
                     return factor * segment.bounds.drift(s.time, segment.speed);
                   }});
  };
  if (effects.momentumIsKnown()) {
    add(effects.pushes.empty() ? "L conserved" : "L = L0 + torque t", "L, less the torques' impulse,", segment.momentum,
        of_momentum, [&body, from = segment.first().time](const State& s, const Phase& p) {
          return Vector3d(body.momentum(p) - body.effects().impulse(from, s.time));
        });
  }
  if (effects.onlyWeights()) {
    const Weights weights(body);
    add("E - m g.Rc conserved", "E - m g.Rc", segment.energy + weights.moment, of_energy + weights.moment,
        [&body](const State&, const Phase& p) {
          double e = body.energy(p);
          for (const Effects::Weight& w : body.effects().weights) e -= w.mass * w.gravity.dot(p.attitude * w.centre);
          return Vector3d(e, 0, 0);
        });
    if (weights.parallel && !weights.gravity.isZero(0)) {
      add("L along g conserved", "the component of L along g", segment.momentum, of_momentum,
          [&body, g = weights.gravity](const State&, const Phase& p) {
            return Vector3d(body.momentum(p).dot(g), 0, 0);
          });
    }
    if (weights.parallel && weights.centre.norm() > 0 && weights.symmetric(body.inertia())) {
      add("L along the top's axis conserved", "the component of L along a symmetric top's axis", segment.momentum,
          of_momentum, [&body, axis = Vector3d(weights.centre.normalized())](const State&, const Phase& p) {
            return Vector3d((body.inertia().tensor * p.omega).dot(axis), 0, 0);
          });
    }
  }
  if (effects.onlyOrbit()) {
    const Effects::Orbit& orbit = effects.orbits[0];
    const double n = orbit.rate, potential = 1.5 * n * n * body.inertia().moments[2];
    add("E - n N.L + 3/2 n^2 u'Mu conserved", "E - n N.L + 3/2 n^2 u'Mu",
        segment.energy + n * segment.momentum + potential, of_energy + n * of_momentum + 2 * potential,
        [&body, &orbit, n](const State& s, const Phase& p) {
          const Vector3d u = p.attitude.conjugate() * orbit.radialAt(s.time);
          const double e = body.energy(p) + 1.5 * n * n * u.dot(body.inertia().tensor * u);
          return Vector3d(e - n * orbit.normal.dot(body.momentum(p)), 0, 0);
        });
  }
  return out;
}

void judgeFall(const Segment& segment, double ceiling, Judge& judge) {
  const RigidBody& body = *segment.body;
  const auto energyOf = [&](const Phase& p) {
    return body.energy(p) + 0.5 * body.slugInertia() * p.slug_omega.squaredNorm();
  };
  judge.ifNothing("no two messages with different times");
  for (std::size_t i = 1; i < segment.states.size(); ++i) {
    const State *a = segment.states[i - 1], *b = segment.states[i];
    if (a->time > b->time) std::swap(a, b);
    const Phase p = segment.phase(*a);
    const double before = energyOf(p), after = energyOf(segment.phase(*b)), at = seconds(b->stamp);
    if (!(before > 0)) {
      judge.compare(after, 0, at, [] { return "a body at rest begins to turn"; });
      continue;
    }
    const double speed = body.speed(a->time, p), size = (body.inertia().moments[2] + body.slugInertia()) * speed;
    const double may_rise = 2e-14 + segment.bounds.allowed(*a, speed, b->time - a->time);
    judge.compare(std::max(0.0, after / before - 1), std::min(may_rise * size * speed / before, ceiling), at,
                  [] { return "energy rises although nothing but damping acts"; });
  }
}

void judgeSlugsStart(const Evidence& evidence, std::vector<Check>& checks) {
  Judge judge("slug starts with the body", evidence.body.key);
  for (const Segment& segment : evidence.segments) {
    const double j = segment.body->slugInertia();
    const Inertia& inertia = segment.body->inertia();
    for (const State* s : segment.states) {
      if (!(j > 0) || s->time != 0 || s->omega_body.norm() == 0) continue;
      const Vector3d whole = s->attitude * Vector3d(inertia.tensor * s->omega_body + j * s->omega_body);
      judge.compare(
          (s->momentum_world - whole).norm() / ((inertia.moments[2] + j) * s->omega_body.norm()), 1e-14,
          seconds(s->stamp), [] {
            return "at t = 0 momentum_world is not R (M + J) omega_body, though the slug starts at rest in the body";
          });
    }
  }
  if (judge.count() > 0) checks.push_back(judge.verdict());
}

}  // namespace poinsot::audit
