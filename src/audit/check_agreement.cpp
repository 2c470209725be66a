#include <algorithm>
#include <cmath>

#include "checks.h"

namespace poinsot::audit {
namespace {

constexpr double kAngle = 1e-12;  // rad: the same numbers were sent twice

/**
 * Pairs each state with the message of equal stamp whose attitude is nearest, and fails where too many have none. A
 * state needs none before the first or after the last message of that topic, near an end of the recording.
 */
template <class Message, class Compare>
void pairUp(const Evidence& evidence, const Track<Message>& track, const std::string& what, Judge& judge,
            const Compare& compare) {
  const auto& partners = track.by_stamp;
  const std::vector<State>& states = evidence.body.states;
  const auto [begin, end] = std::minmax_element(states.begin(), states.end(),
                                                [](const State& a, const State& b) { return a.stamp < b.stamp; });
  const Stamp first = partners.empty() ? 0 : partners.begin()->first;
  const Stamp last = partners.empty() ? 0 : partners.rbegin()->first;
  const bool late = !partners.empty() && seconds(first - begin->stamp) <= evidence.options.ends;
  const bool early = !partners.empty() && seconds(end->stamp - last) <= evidence.options.ends;
  std::int64_t missing = 0, wanted = 0;
  const State* first_missing = nullptr;
  for (const State& state : states) {
    const Message* partner = track.at(state.stamp, state.attitude);
    if (!partner && ((late && state.stamp < first) || (early && state.stamp > last))) continue;
    ++wanted;
    if (!partner) {
      if (missing++ == 0) first_missing = &state;
    } else if (state.flaw.empty() && partner->flaw.empty()) {  // else the check of finite numbers fails
      compare(state, *partner);
    }
  }
  if (static_cast<double>(missing) <= evidence.options.losses * static_cast<double>(wanted)) return;
  const double nearest = toNearest(partners, first_missing->stamp);
  const std::string why = partners.empty()
                              ? "no " + what + " was received"
                              : text("no %s at the stamp of a state; the nearest is %.1f ms %s", what.c_str(),
                                     1e3 * std::abs(nearest), nearest > 0 ? "later" : "earlier");
  judge.fail(seconds(first_missing->stamp),
             why + text(" (missing for %lld of %lld states)", static_cast<long long>(missing),
                        static_cast<long long>(wanted)));
}

/** Compares the attitude and the position that both messages hold. @param whose "tf's" */
void comparePoses(const Pose& pose, const State& state, const char* whose, Judge& judge, bool with_position = true) {
  const double at = seconds(state.stamp), angle = angleBetween(pose.attitude, state.attitude);
  judge.compare(angle, kAngle, at, [&] {
    const bool inverse = angleBetween(pose.attitude, state.attitude.conjugate()) < 1e-9;
    return std::string(whose) + " rotation " +
           (inverse ? "is the inverse of the state's" : text("differs from the state's by %.3g rad", angle));
  });
  if (!with_position) return;
  const double off = (pose.position - state.position).norm();
  judge.compare(off, 1e-12 * std::max(1.0, state.position.norm()), at,
                [&] { return text("%s position differs from the state's by %.3g m", whose, off); });
}

void judgeTf(const Evidence& evidence, std::vector<Check>& checks) {
  const Body& body = evidence.body;
  Judge judge("tf = state", body.key, "rad, m");
  const Track<Transform> none;
  const auto* found = evidence.transforms.moving(body.frame);
  pairUp(evidence, found ? *found : none, "tf", judge, [&](const State& s, const Transform& t) {
    comparePoses(t, s, "tf's", judge);
    if (t.frame_id == s.frame_id) return;
    judge.fail(seconds(s.stamp), "tf places " + body.frame + " in " + t.frame_id + ", the state is in " + s.frame_id);
  });
  checks.push_back(judge.verdict());

  // The picture's own turning frame is published only together with the picture.
  const std::string frame = body.frame + "_space_body";
  const auto* picture = evidence.transforms.moving(frame);
  if (!picture) return;
  Judge space("tf of space_body = state", body.key, "rad");
  pairUp(evidence, *picture, "tf of " + frame, space,
         [&](const State& s, const Transform& t) { comparePoses(t, s, "tf's", space, false); });
  checks.push_back(space.verdict());
}

void judgeOdometry(const Evidence& evidence, std::vector<Check>& checks) {
  const Body& body = evidence.body;
  Judge pose("odometry = state", body.key, "rad, m"), twist("odometry twist in body axes", body.key);
  pairUp(evidence, body.odometry, "odometry", pose, [&](const State& s, const Odometry& o) {
    const double at = seconds(s.stamp);
    comparePoses(o, s, "odometry's", pose);
    if (!endsWith(o.child_frame_id, body.name)) {
      pose.fail(at, "odometry's child_frame_id is \"" + o.child_frame_id + "\", not the frame of " + body.name);
    }
    if (o.frame_id != s.frame_id) {
      pose.fail(at, "odometry's frame_id is \"" + o.frame_id + "\", the state's \"" + s.frame_id + "\"");
    }
    const double rate = std::max(s.omega_body.norm(), 1e-300), speed = std::max(s.velocity.norm(), 1e-300);
    twist.compare((o.angular - s.omega_body).norm() / rate, 1e-14, at, [&] {
      const bool world = (o.angular - s.omega_world).norm() < 1e-9 * rate;
      return std::string("odometry twist.angular is not omega_body") + (world ? " (it looks like omega_world)" : "");
    });
    twist.compare((o.linear - s.attitude.conjugate() * s.velocity).norm() / speed, 1e-14, at, [&] {
      const bool world = (o.linear - s.velocity).norm() < 1e-9 * speed;
      return std::string("odometry twist.linear is not the velocity in body axes") +
             (world ? " (it looks like the velocity in world axes)" : "");
    });
  });
  checks.push_back(pose.verdict());
  if (twist.count() > 0) checks.push_back(twist.verdict());
}

}  // namespace

void judgeAgreement(const Evidence& evidence, std::vector<Check>& checks) {
  if (evidence.options.tf) judgeTf(evidence, checks);
  if (evidence.options.odometry) judgeOdometry(evidence, checks);
}

}  // namespace poinsot::audit
