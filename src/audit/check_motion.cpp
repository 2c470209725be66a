#include <algorithm>
#include <cmath>

#include "checks.h"

namespace poinsot::audit {
namespace {

using Eigen::Vector3d;

constexpr double kStampRounding = 2e-9;   // s: two stamps, each rounded to 1 ns
constexpr double kLongTooVague = 0.01;    // rad: a bound above this ends a comparison over many messages
constexpr double kMostSubsteps = 200000;  // of such a comparison

/** Two consecutive states of one segment, and the times between them. */
struct Interval {
  Interval(const State& from, const State& to) : a(from), b(to) {}

  const State &a, &b;
  double stamps = seconds(b.stamp - a.stamp);                 ///< [s]
  double duration = a.time_rate * stamps;                     ///< simulation time by stamps and time_rate [s]
  double rounding = std::abs(a.time_rate) * kStampRounding;   ///< of `duration` [s]
  double time = b.time - a.time;                              ///< simulation time by the field `time` [s]
  bool same = std::abs(time - duration) <= rounding + 1e-12;  ///< whether both agree
};

/** Returns in words how the turn from a to b differs from the expected one. @param theta that one, in the axes of a
 * [rad] */
std::string wrongTurn(const Interval& v, const Vector3d& theta) {
  const Eigen::Quaterniond back = v.a.attitude.conjugate();
  const Vector3d actual = rotationVector(back * v.b.attitude);
  if (v.duration == 0) {
    return text("time stands still (time_rate %g) but R turns by %.3g rad between two messages", v.a.time_rate,
                actual.norm());
  }
  const double wanted = theta.norm(), ratio = actual.dot(theta) / (wanted * wanted);
  if ((actual - ratio * theta).norm() < 0.05 * std::abs(ratio - 1) * wanted) {
    return text("R turns %.4f times as far as time_rate·Ω says (%.6g rad in %.6g s of stamp)", ratio, actual.norm(),
                v.stamps);
  }
  const double missed = (actual - theta).norm();
  if ((actual - back * theta).norm() < 0.1 * missed) return "omega_body looks like the angular velocity in world axes";
  if ((rotationVector(v.a.attitude * v.b.attitude.conjugate()) - theta).norm() < 0.1 * missed) {
    return "the attitude looks inverted: world to body, not body to world";
  }
  return text("R turns by %.6g rad in %.6g s of stamp, time_rate·Ω says %.6g rad; they differ by %.3g rad",
              actual.norm(), v.stamps, wanted, missed);
}

/** Checks that the messages show one motion: the audit's own integration leads from each to the next and beyond. */
class Motion {
 public:
  Motion(const Evidence& evidence, std::vector<Check>& checks)
      : evidence_(evidence),
        checks_(checks),
        time_("time advances by time_rate", evidence.body.key, "s"),
        rotation_("dR/dstamp = time_rate R hat(omega)", evidence.body.key, "rad"),
        euler_(evidence.body.isFree() ? "Euler's equations" : "Euler's equations with torque", evidence.body.key),
        far_attitude_("one motion: attitude", evidence.body.key, "rad"),
        far_omega_("one motion: omega", evidence.body.key),
        torques_(evidence.body.key) {}

  /** @param known whether all torques on the body are known; otherwise only the time is judged. */
  void judge(bool known) {
    std::string unknown;
    for (const Segment& segment : evidence_.segments) {
      if (unknown.empty()) unknown = segment.bounds.unknown();
      segment.forPairs([&](const State& a, const State& b) {
        judgeTime(Interval(a, b));
        if (known) judgePair(segment, Interval(a, b));
      });
      if (known && segment.body->effects().turns) judgeFar(segment);
    }
    time_.ifNothing("no two consecutive messages of one segment");
    checks_.push_back(time_.verdict());
    if (!known) return;
    if (!unknown.empty()) rotation_.note(unknown + "; 1e-3 of the turn was allowed for it");
    std::vector<Judge*> of_pairs = {&rotation_, &euler_};
    torques_.addTo(of_pairs, evidence_);
    for (Judge* judge : of_pairs) concludePairs(*judge);
    // Recordings that are too short or too vague for a comparison over many messages are judged by pairs alone.
    for (Judge* judge : {&far_attitude_, &far_omega_}) {
      if (judge->count() > 0) checks_.push_back(judge->verdict());
    }
  }

 private:
  void concludePairs(Judge& judge) {
    judge.ifNothing(skipped_ > 0 ? "the body turns too far between any two messages to be judged"
                                 : "no two consecutive messages of one segment");
    if (skipped_ > 0 && judge.count() > 0) {
      judge.note(text("%lld pairs of messages lie too far apart to be judged", static_cast<long long>(skipped_)));
    }
    checks_.push_back(judge.verdict());
  }

  void judgeTime(const Interval& v) {
    const double bound = v.rounding + 1e-15 * (1 + std::abs(v.a.time) + std::abs(v.b.time));
    time_.compare(std::abs(v.time - v.duration), bound, seconds(v.b.stamp), [&] {
      return text("time advances by %.9g s while time_rate %g over %.9g s of stamp says %.9g s", v.time, v.a.time_rate,
                  v.stamps, v.duration) +
             (v.duration != 0 ? text(" (ratio %.4f)", v.time / v.duration) : "");
    });
  }

  void judgePair(const Segment& segment, const Interval& v) {
    // R is compared after time_rate times the stamps, Ω and L after `time`, so that one wrong field fails one check.
    const auto by_time = follow(segment, v.a, v.time);
    const auto other = v.same ? std::nullopt : follow(segment, v.a, v.duration);
    if (const auto& by_rate = v.same ? by_time : other) {
      judgeTurn(v, *by_rate);
    } else {
      ++skipped_;
    }
    if (!by_time) return;
    const RigidBody& body = *segment.body;
    const Phase start = segment.phase(v.a), reached = segment.phase(v.b), &end = by_time->to.end;
    const double speed = std::max(body.speed(v.a.time, start), body.speed(v.b.time, reached)), at = seconds(v.b.stamp);
    if (speed == 0 || (body.speed(v.a.time, start) == 0 && !body.effects().turns)) {
      euler_.compare(reached.omega.norm(), 0, at, [] { return "a body at rest begins to turn without a torque"; });
    } else {
      euler_.compare(omegaDifference(reached, end) / speed, by_time->omega, at, [&] {
        return text(
            "omega_body changes by %.6g rad/s in %.6g s; Euler's equations with this inertia%s say %.6g rad/s; "
            "they differ by %.3g rad/s",
            omegaDifference(reached, start), v.time, body.effects().turns ? " and these effects" : "",
            omegaDifference(end, start), omegaDifference(reached, end));
      });
    }
    if (body.effects().turns) torques_.judge(segment, v.a, v.b, *by_time);
  }

  void judgeTurn(const Interval& v, const Followed& followed) {
    Eigen::Quaterniond expected = followed.to.end.attitude;
    if (v.same) expected = expected * rotationBy((v.duration - v.time) * followed.to.end.omega);
    const double rate = std::max(v.a.omega_body.norm(), v.b.omega_body.norm());
    rotation_.compare(angleBetween(expected, v.b.attitude), followed.attitude + rate * v.rounding + 4e-15,
                      seconds(v.b.stamp),
                      [&] { return wrongTurn(v, rotationVector(v.a.attitude.conjugate() * expected)); });
  }

  /** Compares states over as many messages as can be followed: errors too small to be seen in a pair add up. */
  void judgeFar(const Segment& segment) {
    const std::vector<const State*>& states = segment.states;
    for (std::size_t i = 0, j; i + 2 < states.size() && (j = judgeFrom(segment, i)) < states.size();) {
      i = std::max(i + 1, j - 1);
    }
  }

  /** Does so from message i on. @return the index of the first that could not be followed. */
  std::size_t judgeFrom(const Segment& segment, std::size_t i) {
    const RigidBody& body = *segment.body;
    const State& first = *segment.states[i];
    const Phase start = segment.phase(first);
    Phase now = start;
    Neighbours neighbours(body, first.time, start);
    double substeps = 0;
    for (std::size_t j = i + 1; j < segment.states.size(); ++j) {
      const State &a = *segment.states[j - 1], &b = *segment.states[j];
      const double time = b.time - a.time, at = seconds(b.stamp);
      substeps += body.substeps(a.time, now, time, kFine);
      const auto there = substeps < kMostSubsteps ? body.travel(a.time, now, time, kFine) : std::nullopt;
      if (!there || !neighbours.travel(a.time, time)) return j;
      now = there->end;
      const Phase reached = segment.phase(b);
      const double u = uncertainty(segment, first, b.time - first.time) + substeps * kFineError;
      const double speed = std::max(body.speed(first.time, start), body.speed(b.time, reached));
      const double bound = u * (1 + neighbours.growth(attitudeDifference));
      if (!(bound < kLongTooVague) || speed == 0) return j;
      if (j == i + 1) continue;  // judged as a pair
      const double angle = attitudeDifference(now, reached), off = omegaDifference(now, reached);
      far_attitude_.compare(angle, bound, at, [&] {
        return text("the motion that begins with the state at time %.6g s is off by %.3g rad at %.6g s", first.time,
                    angle, b.time);
      });
      far_omega_.compare(off / speed, u * (1 + neighbours.growth(omegaDifference) / speed), at, [&] {
        return text("omega of the motion that begins with the state at time %.6g s is off by %.3g rad/s at %.6g s",
                    first.time, off, b.time);
      });
    }
    return segment.states.size();
  }

  const Evidence& evidence_;
  std::vector<Check>& checks_;
  Judge time_, rotation_, euler_, far_attitude_, far_omega_;
  TorqueJudges torques_;
  std::int64_t skipped_ = 0;
};

/** Checks that position and velocity are those of the description's translation, or else those of a body that stays. */
void judgePosition(const Evidence& evidence, std::vector<Check>& checks) {
  Judge judge("position and velocity", evidence.body.key, "m, m/s");
  for (const Segment& segment : evidence.segments) {
    const auto& moved = segment.description->forces.translation;
    const Effects::Translation still{segment.first().position, Vector3d::Zero(), Vector3d::Zero()};
    const Effects::Translation& t = moved ? *moved : still;
    const std::string wanted = moved ? "what the description's translation says" : "that of a body without translation";
    for (const State* s : segment.states) {
      const Vector3d p = t.position + s->time * (t.velocity + 0.5 * s->time * t.acceleration);
      const Vector3d v = t.velocity + s->time * t.acceleration;
      const double far = std::abs(s->time), speed = t.velocity.norm() + far * t.acceleration.norm();
      judge.compare((s->position - p).norm(), 1e-14 * (t.position.norm() + far * speed), seconds(s->stamp), [&] {
        return text("position is not %s; they differ by %.3g m", wanted.c_str(), (s->position - p).norm());
      });
      judge.compare((s->velocity - v).norm(), 1e-14 * speed, seconds(s->stamp), [&] {
        return text("velocity is not %s; they differ by %.3g m/s", wanted.c_str(), (s->velocity - v).norm());
      });
    }
  }
  checks.push_back(judge.verdict());
}

}  // namespace

void judgeMotion(const Evidence& evidence, std::vector<Check>& checks) {
  // Where an effect cannot be read, what depends on it is not known; the check "effects" has failed for that.
  Motion(evidence, checks).judge(evidence.body.torquesAreRead());
  if (evidence.body.translationIsRead()) judgePosition(evidence, checks);
}

}  // namespace poinsot::audit
