#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include "poinsot/audit/checks.h"
#include "poinsot/audit/driven_bounds.h"
#include "poinsot/audit/driven_motion.h"
#include "turns.h"

namespace poinsot::audit {
namespace {

using Eigen::Vector3d;

constexpr double kFine = 0.005;  // rad at rate(): substeps of the audit's own integration
constexpr double kFineError = kFine * kFine * kFine * kFine * kFine / 30;
constexpr double kTooVague = 0.05;        // rad: a bound above this judges nothing
constexpr double kLongTooVague = 0.01;    // rad: where a long look ends and the next begins
constexpr double kMostSubsteps = 200000;  // of a long look

/** The usable states of one segment, and what is known of the body in it. */
struct Segment {
  std::vector<const State*> states;
  std::shared_ptr<const DrivenBody> body;
  std::shared_ptr<const DrivenBounds> bounds;
  double speed = 0, momentum = 0, energy = 0;  ///< the greatest in it
};

std::vector<Segment> segmentsOf(const Body& body) {
  std::vector<Segment> segments;
  for (std::size_t begin = 0, end; begin < body.states.size(); begin = end) {
    Segment segment;
    for (end = begin; end < body.states.size() && body.states[end].segment == body.states[begin].segment; ++end) {
      if (body.states[end].flaw.empty()) segment.states.push_back(&body.states[end]);
    }
    if (segment.states.empty()) continue;
    const Description& d = *body.descriptionAt(segment.states.back()->stamp);
    segment.body = std::make_shared<DrivenBody>(Inertia(d.tensor), d.forces);
    segment.bounds = std::make_shared<DrivenBounds>(d, *segment.body, segment.states);
    for (const State* s : segment.states) {
      const Phase p = phaseOf(*segment.body, *s);
      segment.speed = std::max(segment.speed, segment.body->speed(s->time, p));
      segment.momentum = std::max(segment.momentum, segment.body->momentum(p).norm());
      segment.energy = std::max(segment.energy, segment.body->energy(p));
    }
    segments.push_back(std::move(segment));
  }
  return segments;
}

double slugInertia(const DrivenBody& body) {
  return body.effects().slug ? body.effects().slug->inertia : 0;
}

/** What the beginning of a motion is uncertain by: rounding, and what the method adds by its end [rad, speed]. */
double uncertainty(const Segment& segment, const State& a, double duration, const Phase& start) {
  const DrivenBody& body = *segment.body;
  const Inertia& inertia = body.inertia();
  const double substeps = body.substeps(a.time, start, duration, kFine);
  const double steps = segment.bounds->steps(duration), rate = body.rate(a.time, start);
  double rounding = 1e-15 * (10 + inertia.moments[2] / inertia.moments[0] + std::sqrt(substeps) + std::sqrt(steps)) +
                    5e-17 * steps + 4e-16 * rate * (std::abs(a.time) + std::abs(a.time + duration));
  const double speed = body.speed(a.time, start);
  if (const double j = slugInertia(body); j > 0 && speed > 0) {
    rounding += 1e-15 * (a.momentum_world.norm() + inertia.moments[2] * start.omega.norm()) / (j * speed);
  }
  const double own = std::min(substeps * kFineError, std::pow(rate * std::abs(duration), 5) / 30);
  return rounding + own + segment.bounds->allowed(duration, speed);
}

double attitudeDifference(const Phase& a, const Phase& b) {
  return angleBetween(a.attitude, b.attitude);
}

class Driven {
 public:
  Driven(const Evidence& evidence, std::vector<Check>& checks)
      : evidence_(evidence),
        checks_(checks),
        rotation_("dR/dstamp = time_rate R hat(omega)", key(), "rad"),
        euler_("Euler's equations with torque", key()),
        momentum_("dL/dt = torque", key()),
        energy_("dE/dt = power", key()),
        slug_("slug's equation", key()),
        far_attitude_("one motion: attitude", key(), "rad"),
        far_omega_("one motion: omega", key()),
        segments_(segmentsOf(evidence.body)) {}

  void judge() {
    bool has_slug = false;
    for (const Segment& segment : segments_) {
      has_slug = has_slug || segment.body->effects().slug;
      if (!segment.bounds->known() && notes_++ == 0) {
        const DrivenBounds& bounds = *segment.bounds;
        rotation_.note("method \"" + bounds.method() + "\"" +
                       (bounds.tooCoarse()
                            ? text(" at step %g s is too coarse to be held to a bound of its own", bounds.step())
                            : " is not known here") +
                       "; 1e-3 of the turn was allowed for it");
      }
      for (std::size_t i = 0; i + 1 < segment.states.size(); ++i) judgePair(segment, i);
      judgeFar(segment);
    }
    for (Judge* judge : {&rotation_, &euler_, &momentum_, &energy_, &slug_}) {
      judge->ifNothing(skipped_ > 0 ? "the body turns too far between two messages to judge"
                                    : "no two consecutive messages of one segment");
      if (skipped_ > 0 && judge->count() > 0) {
        judge->note(text("%lld pairs of messages lie too far apart to judge", static_cast<long long>(skipped_)));
      }
      if (judge == &slug_ && !has_slug) continue;
      if (judge == &energy_ && at_rest_ && energy_.count() == 0) continue;
      checks_.push_back(judge->verdict());
    }
    // Of recordings too short, or too vague, for a long look the pairs were judged.
    for (Judge* judge : {&far_attitude_, &far_omega_}) {
      if (judge->count() > 0) checks_.push_back(judge->verdict());
    }
    if (has_slug) judgeSlugsStart();
    judgeConserved();
  }

 private:
  const std::string& key() const { return evidence_.body.key; }

  /** From one message to the next. */
  void judgePair(const Segment& segment, std::size_t i) {
    const State &a = *segment.states[i], &b = *segment.states[i + 1];
    if (b.stamp < a.stamp || &b != &a + 1) return;
    const DrivenBody& body = *segment.body;
    const double stamps = seconds(b.stamp - a.stamp), duration = a.time_rate * stamps, time = b.time - a.time;
    const double rounding = std::abs(a.time_rate) * kStampRounding, at = seconds(b.stamp);
    const Phase start = phaseOf(body, a), reached = phaseOf(body, b);
    const bool same = std::abs(time - duration) <= rounding + 1e-12;

    const double u = uncertainty(segment, a, time, start);
    Neighbours neighbours(body, a.time, start);
    const auto end = u < kTooVague ? body.travel(a.time, start, time, kFine) : std::nullopt;
    const bool followed = end && neighbours.travel(a.time, time);
    const double attitude_bound = followed ? u * (1 + neighbours.growth(attitudeDifference)) : kTooVague;
    if (!(attitude_bound < kTooVague)) {
      if (same) {
        ++skipped_;
        return;
      }
    }
    const Interval interval{a, b, stamps, duration, rounding};
    if (same) {
      compareTurn(rotation_, interval,
                  {rotationVector(a.attitude.conjugate() * end->end.attitude),
                   attitude_bound + a.omega_body.norm() * std::abs(time - duration)},
                  b.omega_body.norm() * rounding);
    } else {
      // What time_rate says and what time does are two things: each is followed.
      const double v = uncertainty(segment, a, duration, start);
      const auto there = v < kTooVague ? body.travel(a.time, start, duration, kFine) : std::nullopt;
      Neighbours others(body, a.time, start);
      if (there && others.travel(a.time, duration)) {
        compareTurn(
            rotation_, interval,
            {rotationVector(a.attitude.conjugate() * there->end.attitude), v * (1 + others.growth(attitudeDifference))},
            0);
      } else {
        ++skipped_;
      }
    }
    if (!(attitude_bound < kTooVague)) return;

    const double speed = std::max(body.speed(a.time, start), body.speed(b.time, reached));
    if (speed == 0) {
      at_rest_ = true;
      euler_.compare(b.omega_body.norm(), 0, at, [] { return "nothing turns the body, yet it begins to turn"; });
      momentum_.compare(b.momentum_world.norm(), 0, at);
      return;
    }
    const auto omegaDifference = [](const Phase& p, const Phase& q) { return (p.omega - q.omega).norm(); };
    const auto slugDifference = [](const Phase& p, const Phase& q) { return (p.slug_omega - q.slug_omega).norm(); };
    const auto momentumDifference = [&body](const Phase& p, const Phase& q) {
      return (body.momentum(p) - body.momentum(q)).norm();
    };
    const auto energyDifference = [&body](const Phase& p, const Phase& q) {
      return std::abs(body.energy(p) - body.energy(q));
    };
    euler_.compare((reached.omega - end->end.omega).norm() / speed,
                   u * (1 + neighbours.growth(omegaDifference) / speed), at, [&] {
                     return text(
                         "omega_body changes by %.6g rad/s in %.6g s; Euler's equations with this inertia and "
                         "these effects say %.6g rad/s; they differ by %.3g rad/s",
                         (reached.omega - start.omega).norm(), time, (end->end.omega - start.omega).norm(),
                         (reached.omega - end->end.omega).norm());
                   });
    const double inertia = body.inertia().moments[2] + slugInertia(body);
    const Vector3d la = body.momentum(start), lb = body.momentum(reached);
    const double l_scale = std::max({la.norm(), lb.norm(), end->impulse.norm()});
    if (l_scale > 0) {
      momentum_.compare((lb - la - end->impulse).norm() / l_scale,
                        u * (inertia * speed + neighbours.growth(momentumDifference)) / l_scale, at, [&] {
                          return text(
                              "L changes by %.6g kg m^2/s in %.6g s, the impulse of the torques is %.6g; they "
                              "differ by %.3g",
                              (lb - la).norm(), time, end->impulse.norm(), (lb - la - end->impulse).norm());
                        });
    }
    const double ea = body.energy(start), eb = body.energy(reached), e_scale = std::max(ea, eb);
    if (e_scale > 0) {
      const double l_most = body.inertia().moments[2] * std::max(start.omega.norm(), reached.omega.norm());
      energy_.compare(std::abs(eb - ea - end->work) / e_scale,
                      u * (l_most * speed + neighbours.growth(energyDifference)) / e_scale, at, [&] {
                        return text("kinetic energy changes by %.6g J in %.6g s, the work of the torques is %.6g J",
                                    eb - ea, time, end->work);
                      });
    }
    if (body.effects().slug) {
      slug_.compare((reached.slug_omega - end->end.slug_omega).norm() / speed,
                    u * (1 + neighbours.growth(slugDifference) / speed), at, [&] {
                      return text(
                          "the slug's rate, (R'L - M omega)/J, changes by %.6g rad/s in %.6g s; its equation "
                          "says %.6g rad/s",
                          (reached.slug_omega - start.slug_omega).norm(), time,
                          (end->end.slug_omega - start.slug_omega).norm());
                    });
    }
  }

  /** From one message over as many others as can be followed: what is too little to be seen in a pair adds up. */
  void judgeFar(const Segment& segment) {
    const DrivenBody& body = *segment.body;
    std::size_t i = 0;
    while (i + 2 < segment.states.size()) {
      const State& first = *segment.states[i];
      const Phase start = phaseOf(body, first);
      Phase now = start;
      Neighbours neighbours(body, first.time, start);
      double substeps = 0;
      std::size_t j = i + 1;
      for (; j < segment.states.size(); ++j) {
        const State &a = *segment.states[j - 1], &b = *segment.states[j];
        const double time = b.time - a.time;
        substeps += body.substeps(a.time, now, time, kFine);
        const auto end = substeps < kMostSubsteps ? body.travel(a.time, now, time, kFine) : std::nullopt;
        if (!end || !neighbours.travel(a.time, time)) break;
        now = end->end;
        const double u = uncertainty(segment, first, b.time - first.time, start) + substeps * kFineError;
        const Phase reached = phaseOf(body, b);
        const double speed = std::max(body.speed(first.time, start), body.speed(b.time, reached));
        const double bound = u * (1 + neighbours.growth(attitudeDifference));
        if (!(bound < kLongTooVague) || speed == 0) break;
        if (j == i + 1) continue;  // judged as a pair
        const double at = seconds(b.stamp);
        const double angle = angleBetween(now.attitude, reached.attitude);
        far_attitude_.compare(angle, bound, at, [&] {
          return text("the motion that begins with the state at time %.6g s is off by %.3g rad at %.6g s", first.time,
                      angle, b.time);
        });
        const double off = (now.omega - reached.omega).norm();
        const double grown =
            neighbours.growth([](const Phase& p, const Phase& q) { return (p.omega - q.omega).norm(); });
        far_omega_.compare(off / speed, u * (1 + grown / speed), at, [&] {
          return text("omega of the motion that begins with the state at time %.6g s is off by %.3g rad/s at %.6g s",
                      first.time, off, b.time);
        });
      }
      i = j > i + 1 ? j - 1 : i + 1;
      if (j == segment.states.size()) break;
    }
  }

  /** The slug starts with the body; of recordings that show t = 0. */
  void judgeSlugsStart() {
    Judge judge("slug starts with the body", key());
    for (const Segment& segment : segments_) {
      const DrivenBody& body = *segment.body;
      if (!body.effects().slug) continue;
      const double inertia = body.inertia().moments[2] + slugInertia(body);
      for (const State* s : segment.states) {
        if (s->time != 0 || s->omega_body.norm() == 0) continue;
        const Vector3d whole =
            s->attitude * (body.inertia().tensor * s->omega_body + slugInertia(body) * s->omega_body);
        judge.compare(
            (s->momentum_world - whole).norm() / (inertia * s->omega_body.norm()), 1e-14, seconds(s->stamp),
            [] { return "at t = 0 momentum_world is not R (M + J) omega_body, as a slug at rest in the body has it"; });
      }
    }
    if (judge.count() > 0) checks_.push_back(judge.verdict());
  }

  /** Something of the true motion that never changes. */
  struct Constant {
    const char* name;
    const char* words;
    std::function<Vector3d(const State&, const Phase&)> value;
    double scale;     ///< what its size is compared with
    double by_error;  ///< how much an error of 1 rad, or of the whole speed, may change it
  };

  std::vector<Constant> constantsOf(const Segment& segment) const {
    const DrivenBody& body = *segment.body;
    const Effects& effects = body.effects();
    const Inertia& inertia = body.inertia();
    const double inertias = inertia.moments[2] + slugInertia(body);
    const double of_momentum = inertias * segment.speed, of_energy = segment.momentum * segment.speed;
    std::vector<Constant> out;
    if (effects.momentumIsKnown()) {
      const double from = segment.states.front()->time;
      out.push_back({effects.pushes.empty() ? "L conserved" : "L = L0 + torque t", "L, less the torques' impulse,",
                     [&body, from](const State& s, const Phase& p) {
                       return Vector3d(body.momentum(p) - body.effects().impulse(from, s.time));
                     },
                     segment.momentum, of_momentum});
    }
    if (effects.onlyWeights()) {
      double moment = 0;
      Vector3d gravity = Vector3d::Zero(), centre = Vector3d::Zero();
      bool parallel = true;
      for (const Effects::Weight& w : effects.weights) {
        if (gravity.isZero(0)) gravity = w.gravity;
        moment += w.mass * w.gravity.norm() * w.centre.norm();
        parallel = parallel && w.gravity.cross(gravity).norm() <= 1e-14 * w.gravity.norm() * gravity.norm();
        centre += w.mass * w.gravity.dot(gravity.stableNormalized()) * w.centre;
      }
      out.push_back({"E - m g.Rc conserved", "E - m g.Rc",
                     [&body](const State&, const Phase& p) {
                       double e = body.energy(p);
                       for (const Effects::Weight& w : body.effects().weights) {
                         e -= w.mass * w.gravity.dot(p.attitude * w.centre);
                       }
                       return Vector3d(e, 0, 0);
                     },
                     segment.energy + moment, of_energy + moment});
      if (parallel && gravity.norm() > 0) {
        const Vector3d g = gravity.normalized();
        out.push_back({"L along g conserved", "the component of L along g",
                       [&body, g](const State&, const Phase& p) { return Vector3d(body.momentum(p).dot(g), 0, 0); },
                       segment.momentum, of_momentum});
      }
      if (parallel && centre.norm() > 0) {
        const Vector3d axis = centre.normalized(), side = axis.unitOrthogonal(), other = axis.cross(side);
        const double about = side.dot(inertia.tensor * side);
        const Eigen::Matrix3d symmetric = about * (side * side.transpose() + other * other.transpose()) +
                                          axis.dot(inertia.tensor * axis) * axis * axis.transpose();
        if ((symmetric - inertia.tensor).cwiseAbs().maxCoeff() <= 1e-13 * inertia.moments[2]) {
          out.push_back({"L along the top's axis conserved", "the component of L along a symmetric top's axis",
                         [&inertia, axis](const State&, const Phase& p) {
                           return Vector3d((inertia.tensor * p.omega).dot(axis), 0, 0);
                         },
                         segment.momentum, of_momentum});
        }
      }
    }
    if (effects.onlyOrbits()) {
      const Effects::Orbit& orbit = effects.orbits[0];
      const double n = orbit.rate, potential = 1.5 * n * n * inertia.moments[2];
      out.push_back({"E - n N.L + 3/2 n^2 u'Mu conserved", "E - n N.L + 3/2 n^2 u'Mu",
                     [&body, &orbit, n](const State& s, const Phase& p) {
                       const Vector3d u = p.attitude.conjugate() * orbit.radialAt(s.time);
                       return Vector3d(body.energy(p) - n * orbit.normal.dot(body.momentum(p)) +
                                           1.5 * n * n * u.dot(body.inertia().tensor * u),
                                       0, 0);
                     },
                     segment.energy + n * segment.momentum + potential, of_energy + n * of_momentum + 2 * potential});
    }
    return out;
  }

  void judgeConserved() {
    std::vector<std::pair<std::string, Judge>> judges;
    const auto judgeOf = [&](const std::string& name) -> Judge& {
      for (auto& [known, judge] : judges) {
        if (known == name) return judge;
      }
      judges.emplace_back(name, Judge(name, key()));
      return judges.back().second;
    };
    for (const Segment& segment : segments_) {
      for (const Constant& constant : constantsOf(segment)) {
        Judge& judge = judgeOf(constant.name);
        if (!(constant.scale > 0)) {
          judge.compare(0, 0, seconds(segment.states.front()->stamp));
          continue;
        }
        const State& first = *segment.states.front();
        const Vector3d start = constant.value(first, phaseOf(*segment.body, first));
        for (const State* s : segment.states) {
          const double off = (constant.value(*s, phaseOf(*segment.body, *s)) - start).norm() / constant.scale;
          const DrivenBounds& bounds = *segment.bounds;
          const double ceiling = evidence_.options.drift, span = s->time - first.time;
          const double allowed = (bounds.drift(first.time, segment.speed) + bounds.drift(s->time, segment.speed)) *
                                 constant.by_error / constant.scale;
          judge.compare(off, std::min(allowed, ceiling), seconds(s->stamp), [&] {
            const std::string step = bounds.step() > 0 ? text(" at step %g s", bounds.step()) : "";
            return text("%s changes by %.3g in %.6g s, ", constant.words, off, span) +
                   (off <= allowed ? text("more than ground truth may (%g): method %s%s is too coarse", ceiling,
                                          bounds.method().c_str(), step.c_str())
                                   : text("more than method %s%s allows (%.3g)", bounds.method().c_str(), step.c_str(),
                                          std::min(allowed, ceiling)));
          });
        }
      }
      if (segment.body->effects().onlyDissipates()) judgeFall(segment, judgeOf("E never rises"));
    }
    for (auto& [name, judge] : judges) checks_.push_back(judge.verdict());
  }

  /** Dampings and slugs take energy out, at every moment: E, with the slug's ½Jσ². */
  void judgeFall(const Segment& segment, Judge& judge) {
    const DrivenBody& body = *segment.body;
    const auto energyOf = [&](const Phase& p) {
      return body.energy(p) + 0.5 * slugInertia(body) * p.slug_omega.squaredNorm();
    };
    judge.ifNothing("no two messages with different times");
    for (std::size_t i = 1; i < segment.states.size(); ++i) {
      const State *a = segment.states[i - 1], *b = segment.states[i];
      if (a->time > b->time) std::swap(a, b);
      const Phase p = phaseOf(body, *a), q = phaseOf(body, *b);
      const double before = energyOf(p), after = energyOf(q);
      if (!(before > 0)) {
        judge.compare(after, 0, seconds(b->stamp), [] { return "a body at rest begins to turn"; });
        continue;
      }
      const double speed = body.speed(a->time, p), size = (body.inertia().moments[2] + slugInertia(body)) * speed;
      const double allowed = (2e-14 + segment.bounds->allowed(b->time - a->time, speed)) * size * speed / before;
      judge.compare(std::max(0.0, after / before - 1), std::min(allowed, evidence_.options.drift), seconds(b->stamp),
                    [] { return "energy rises although nothing but damping acts"; });
    }
  }

  const Evidence& evidence_;
  std::vector<Check>& checks_;
  Judge rotation_, euler_, momentum_, energy_, slug_, far_attitude_, far_omega_;
  std::vector<Segment> segments_;
  std::int64_t skipped_ = 0;
  int notes_ = 0;
  bool at_rest_ = false;
};

}  // namespace

void judgeDriven(const Evidence& evidence, std::vector<Check>& checks) {
  Driven(evidence, checks).judge();
}

}  // namespace poinsot::audit
