#include <algorithm>
#include <cmath>

#include "poinsot/audit/checks.h"
#include "poinsot/audit/free_motion.h"
#include "poinsot/audit/method_bounds.h"
#include "turns.h"

namespace poinsot::audit {
namespace {

constexpr double kTooVague = 0.05;  // rad: a bound above this judges nothing

/** Calls `visit(i, interval)` for every pair that belongs together. */
template <typename Visit>
void forIntervals(const Body& body, const Visit& visit) {
  for (std::size_t i = 0; i + 1 < body.states.size(); ++i) {
    const State &a = body.states[i], &b = body.states[i + 1];
    if (a.segment != b.segment || b.stamp < a.stamp || !a.flaw.empty() || !b.flaw.empty()) continue;
    const double stamps = seconds(b.stamp - a.stamp);
    visit(i, Interval{a, b, stamps, a.time_rate * stamps, std::abs(a.time_rate) * kStampRounding});
  }
}

void judgeTime(const Evidence& evidence, std::vector<Check>& checks) {
  Judge judge("time advances by time_rate", evidence.body.key, "s");
  judge.ifNothing("no two consecutive messages of one segment");
  forIntervals(evidence.body, [&](std::size_t, const Interval& v) {
    const double advance = v.b.time - v.a.time;
    const double bound = v.rounding + 1e-15 * (1 + std::abs(v.a.time) + std::abs(v.b.time));
    judge.compare(std::abs(advance - v.duration), bound, seconds(v.b.stamp), [&] {
      return text("time advances by %.9g s while time_rate %g over %.9g s of stamp says %.9g s", advance, v.a.time_rate,
                  v.stamps, v.duration) +
             (v.duration != 0 ? text(" (ratio %.4f)", advance / v.duration) : "");
    });
  });
  checks.push_back(judge.verdict());
}

void noteUnknown(const MethodBounds& bounds, Judge& judge) {
  judge.note("method \"" + bounds.method() + "\" is not known here; 1e-3 of the turn was allowed for it");
}

void sayTooVague(std::int64_t skipped, Judge& judge) {
  if (skipped == 0) return;
  judge.ifNothing("the body turns too far between two messages to judge");
  if (judge.count() > 0) {
    judge.note(text("%lld pairs of messages lie too far apart to judge", static_cast<long long>(skipped)));
  }
}

/** A free body's messages must be one motion: the audit's own integration goes from each to the next. */
void judgeFreeRotation(const Evidence& evidence, std::vector<Check>& checks) {
  const Body& body = evidence.body;
  Judge rotation("dR/dstamp = time_rate R hat(omega)", body.key, "rad"), euler("Euler's equations", body.key);
  const Description* description = nullptr;
  std::optional<Inertia> inertia;
  std::optional<MethodBounds> bounds;
  std::int64_t skipped = 0;
  for (Judge* judge : {&rotation, &euler}) judge->ifNothing("no two consecutive messages of one segment");
  forIntervals(body, [&](std::size_t, const Interval& v) {
    if (const Description* d = body.descriptionAt(v.b.stamp); d != description) {
      description = d;
      inertia.emplace(d->tensor);
      bounds.emplace(*d);
      if (!bounds->known()) noteUnknown(*bounds, rotation);
    }
    const double w = inertia->fastestRate(v.a.omega_body);
    const auto allowed = [&](double duration) {
      return bounds->known()
                 ? bounds->local(*inertia, v.a.omega_body, duration, std::max(std::abs(v.a.time), std::abs(v.b.time)))
                 : 1e-3 * w * std::abs(duration) + 1e-12;
    };
    const double own = freeMotionError(*inertia, v.a.omega_body, v.duration), method = allowed(v.duration);
    const auto end =
        own + method < kTooVague ? freeMotion(*inertia, {v.a.attitude, v.a.omega_body}, v.duration) : std::nullopt;
    if (!end) {
      ++skipped;
      return;
    }
    compareTurn(rotation, v, {rotationVector(v.a.attitude.conjugate() * end->attitude), own}, method);

    // Ω follows `time`, whatever time_rate says: one wrong field, one check.
    const double time = v.b.time - v.a.time;
    const bool same = std::abs(time - v.duration) <= v.rounding + 1e-12;
    if (!same && freeMotionError(*inertia, v.a.omega_body, time) + allowed(time) > kTooVague) return;
    const auto at_time = same ? end : freeMotion(*inertia, {v.a.attitude, v.a.omega_body}, time);
    if (!at_time || w == 0) {
      euler.compare((v.b.omega_body - v.a.omega_body).norm(), 0, seconds(v.b.stamp),
                    [] { return "a free body at rest begins to turn"; });
      return;
    }
    const double error = freeMotionError(*inertia, v.a.omega_body, time) + allowed(time) + w * v.rounding;
    euler.compare((v.b.omega_body - at_time->omega_body).norm() / w, error, seconds(v.b.stamp), [&] {
      return text("omega_body changes by %.6g rad/s in %.6g s; Euler's equations with this inertia say %.6g rad/s",
                  (v.b.omega_body - v.a.omega_body).norm(), time, (at_time->omega_body - v.a.omega_body).norm());
    });
  });
  sayTooVague(skipped, rotation);
  sayTooVague(skipped, euler);
  checks.push_back(rotation.verdict());
  checks.push_back(euler.verdict());
}

/** ∫ of the polynomial through some samples of Ω(time), as a turn: Magnus' fourth-order formula in eight pieces. */
Eigen::Vector3d turnThrough(const std::vector<const State*>& nodes, double from, double to) {
  const auto omegaAt = [&nodes](double t) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const State* i : nodes) {
      double weight = 1;
      for (const State* j : nodes) {
        if (i != j) weight *= (t - j->time) / (i->time - j->time);
      }
      sum += weight * i->omega_body;
    }
    return sum;
  };
  constexpr int kPieces = 8;
  const double h = (to - from) / kPieces, gauss = 0.5 / std::sqrt(3.0);
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  for (int k = 0; k < kPieces; ++k) {
    const double middle = from + (k + 0.5) * h;
    const Eigen::Vector3d a = omegaAt(middle - gauss * h), b = omegaAt(middle + gauss * h);
    q = q * rotationBy(0.5 * h * (a + b) + std::sqrt(3.0) / 12 * h * h * a.cross(b));
  }
  return rotationVector(q);
}

/** Where effects cannot be read only kinematics can be asked: R against the integral of Ω interpolated between
 * messages. */
void judgeDrivenRotation(const Evidence& evidence, std::vector<Check>& checks) {
  const Body& body = evidence.body;
  Judge judge("dR/dstamp = time_rate R hat(omega)", body.key, "rad");
  judge.ifNothing("no two consecutive messages of one segment");
  const std::size_t n = body.states.size();

  // Runs in which time goes one way, so that Ω is a function of it.
  std::vector<std::size_t> run_of(n, 0);
  for (std::size_t i = 1; i < n; ++i) {
    const State &a = body.states[i - 1], &b = body.states[i];
    bool joined = a.segment == b.segment && a.flaw.empty() && b.flaw.empty() && b.time != a.time && b.stamp > a.stamp;
    if (joined && i >= 2 && run_of[i - 2] == run_of[i - 1]) {
      joined = (b.time > a.time) == (a.time > body.states[i - 2].time);
    }
    run_of[i] = run_of[i - 1] + !joined;
  }

  std::vector<Turn> turns(n, {Eigen::Vector3d::Zero(), 0});
  forIntervals(body, [&](std::size_t i, const Interval& v) {
    if (run_of[i] != run_of[i + 1]) return;
    // Six samples about the interval, and the same without the farthest: their difference says how good either is.
    std::size_t begin = i, end = i + 2;
    for (int k = 0; k < 2; ++k) {
      if (begin > 0 && run_of[begin - 1] == run_of[i]) --begin;
      if (end < n && run_of[end] == run_of[i]) ++end;
    }
    std::vector<const State*> nodes;
    for (std::size_t k = begin; k < end; ++k) nodes.push_back(&body.states[k]);
    const Eigen::Vector3d best = turnThrough(nodes, v.a.time, v.a.time + v.duration);
    if (i - begin >= end - i - 1 && nodes.size() > 1) {
      nodes.erase(nodes.begin());
    } else {
      nodes.pop_back();
    }
    turns[i] = {best, (best - turnThrough(nodes, v.a.time, v.a.time + v.duration)).norm()};
  });

  const Description* description = nullptr;
  std::optional<Inertia> inertia;
  std::optional<MethodBounds> bounds;
  std::int64_t skipped = 0;
  forIntervals(body, [&](std::size_t i, const Interval& v) {
    if (const Description* d = body.descriptionAt(v.b.stamp); d != description) {
      description = d;
      inertia.emplace(d->tensor);
      bounds.emplace(*d);
      if (!bounds->known()) noteUnknown(*bounds, judge);
    }
    Turn turn{Eigen::Vector3d::Zero(), 0};
    if (v.duration != 0) {
      if (run_of[i] != run_of[i + 1]) {
        ++skipped;
        return;
      }
      turn = turns[i];
      // A difference may vanish by chance, and a torque that sets in leaves its mark on the neighbours.
      for (std::size_t k = i < 2 ? 0 : i - 2; k <= std::min(i + 2, n - 2); ++k) {
        if (run_of[k] == run_of[i]) turn.error = std::max(turn.error, 2 * turns[k].error);
      }
    }
    const double w = inertia->fastestRate(v.a.omega_body), size = std::abs(v.duration);
    const double method = bounds->known() ? bounds->local(*inertia, v.a.omega_body, v.duration,
                                                          std::max(std::abs(v.a.time), std::abs(v.b.time)))
                                          : 1e-3 * w * size;
    if (!(turn.error + method < kTooVague)) {
      ++skipped;
      return;
    }
    compareTurn(judge, v, turn, method);
  });
  sayTooVague(skipped, judge);
  checks.push_back(judge.verdict());
}

/** The position: where nothing moves it, constant; under translation a quadratic in time, velocity its derivative. */
void judgePosition(const Evidence& evidence, std::vector<Check>& checks) {
  const Body& body = evidence.body;
  Judge judge("position and velocity", body.key, "m, m/s");
  for (std::size_t begin = 0, end; begin < body.states.size(); begin = end) {
    std::vector<const State*> states;
    for (end = begin; end < body.states.size() && body.states[end].segment == body.states[begin].segment; ++end) {
      if (body.states[end].flaw.empty()) states.push_back(&body.states[end]);
    }
    if (states.empty()) continue;
    if (!body.descriptionAt(states.back()->stamp)->hasEffect("translation")) {
      for (const State* s : states) {
        judge.compare((s->position - states[0]->position).norm(), 1e-12 * (1 + states[0]->position.norm()),
                      seconds(s->stamp), [] { return "the body has no translation, yet its position changes"; });
        judge.compare(s->velocity.norm(), 1e-12, seconds(s->stamp),
                      [] { return "the body has no translation, yet velocity is not zero"; });
      }
      continue;
    }
    if (const auto& t = body.descriptionAt(states.back()->stamp)->forces.translation) {
      for (const State* s : states) {
        const Eigen::Vector3d p = t->position + s->time * (t->velocity + 0.5 * s->time * t->acceleration);
        const Eigen::Vector3d v = t->velocity + s->time * t->acceleration;
        const double far = std::abs(s->time), speed = t->velocity.norm() + far * t->acceleration.norm();
        judge.compare((s->position - p).norm(), 1e-14 * (t->position.norm() + far * speed), seconds(s->stamp), [&] {
          return text("position is not what the description's translation says; they differ by %.3g m",
                      (s->position - p).norm());
        });
        judge.compare((s->velocity - v).norm(), 1e-14 * speed, seconds(s->stamp), [&] {
          return text("velocity is not what the description's translation says; they differ by %.3g m/s",
                      (s->velocity - v).norm());
        });
      }
    }
    const auto earlier = [](const State* a, const State* b) { return a->time < b->time; };
    const State* first = *std::min_element(states.begin(), states.end(), earlier);
    const State* last = *std::max_element(states.begin(), states.end(), earlier);
    const double span = last->time - first->time, middle_time = 0.5 * (first->time + last->time);
    const State* middle = *std::min_element(states.begin(), states.end(), [&](const State* a, const State* b) {
      return std::abs(a->time - middle_time) < std::abs(b->time - middle_time);
    });
    if (middle == first || middle == last || !(span > 0)) {
      for (const State* s : states) {
        judge.compare(s->time == first->time ? (s->position - first->position).norm() : 0,
                      1e-12 * (1 + first->position.norm()), seconds(s->stamp),
                      [] { return "time stands still, yet the position changes"; });
      }
      continue;
    }
    // Newton's form through three samples.
    const double t0 = first->time, t1 = middle->time, t2 = last->time;
    const Eigen::Vector3d d01 = (middle->position - first->position) / (t1 - t0);
    const Eigen::Vector3d d12 = (last->position - middle->position) / (t2 - t1);
    const Eigen::Vector3d d012 = (d12 - d01) / (t2 - t0);
    double largest = 0, fastest = 0;
    for (const State* s : states) {
      largest = std::max(largest, s->position.norm());
      fastest = std::max(fastest, s->velocity.norm());
    }
    const double far = std::max(std::abs(t0), std::abs(t2));
    const double bound = 1e-14 * (1 + 10 * largest + fastest * far);
    for (const State* s : states) {
      const double t = s->time;
      const Eigen::Vector3d p = first->position + (t - t0) * (d01 + (t - t1) * d012);
      const Eigen::Vector3d v = d01 + (2 * t - t0 - t1) * d012;
      judge.compare((s->position - p).norm(), bound, seconds(s->stamp), [&] {
        return text("position leaves the quadratic in time through the segment's first, middle and last by %.3g m",
                    (s->position - p).norm());
      });
      judge.compare((s->velocity - v).norm(), 1e-13 * (1 + fastest) + 16 * bound / span, seconds(s->stamp), [&] {
        return text("velocity is not the derivative of position: they differ by %.3g m/s", (s->velocity - v).norm());
      });
    }
  }
  checks.push_back(judge.verdict());
}

}  // namespace

void judgeMotion(const Evidence& evidence, std::vector<Check>& checks) {
  judgeTime(evidence, checks);
  const auto& descriptions = evidence.body.descriptions;
  const bool free =
      std::all_of(descriptions.begin(), descriptions.end(), [](const Description& d) { return d.isFree(); });
  if (free) {
    judgeFreeRotation(evidence, checks);
  } else if (evidence.body.effectsAreRead()) {
    judgeDriven(evidence, checks);
  } else {
    judgeDrivenRotation(evidence, checks);
  }
  judgePosition(evidence, checks);
}

}  // namespace poinsot::audit
