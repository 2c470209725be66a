#include <algorithm>
#include <cmath>
#include <limits>

#include "poinsot/audit/checks.h"

namespace poinsot::audit {
namespace {

constexpr double kAngle = 1e-12;  // rad: the same numbers were sent twice

/**
 * Whether a state may do without a partner: it lies before the first or after the last message of the partner's topic,
 * near an end of the recording.
 */
template <typename ByStamp>
bool mayBeAlone(const State& state, const Body& body, const ByStamp& partners, double ends) {
  if (partners.empty()) return false;
  const Stamp first = partners.begin()->first, last = partners.rbegin()->first;
  Stamp begin = body.states.front().stamp, end = begin;
  for (const State* s : {&body.states.front(), &body.states.back()}) {
    begin = std::min(begin, s->stamp);
    end = std::max(end, s->stamp);
  }
  return (state.stamp < first && seconds(first - begin) <= ends) || (state.stamp > last && seconds(end - last) <= ends);
}

template <typename ByStamp>
std::string nearest(const State& state, const ByStamp& partners, const std::string& what) {
  if (partners.empty()) return "no " + what + " was received";
  auto after = partners.lower_bound(state.stamp);
  double best = std::numeric_limits<double>::infinity();
  if (after != partners.end()) best = seconds(after->first - state.stamp);
  if (after != partners.begin()) {
    const double before = seconds(std::prev(after)->first - state.stamp);
    if (std::abs(before) < std::abs(best)) best = before;
  }
  return text("no %s at the stamp of a state; the nearest is %.1f ms %s", what.c_str(), 1e3 * std::abs(best),
              best > 0 ? "later" : "earlier");
}

/** Pairs each state with the message of equal stamp whose attitude is nearest; counts those that are missing. */
template <typename ByStamp, typename Rotation, typename Compare>
void pairUp(const Evidence& evidence, const ByStamp& partners, const std::string& what, Judge& judge,
            const Rotation& rotation, const Compare& compare) {
  std::int64_t missing = 0, wanted = 0;
  const State* first_missing = nullptr;
  for (const State& state : evidence.body.states) {
    const auto [begin, end] = partners.equal_range(state.stamp);
    if (begin == end) {
      if (mayBeAlone(state, evidence.body, partners, evidence.options.ends)) continue;
      ++wanted;
      if (missing++ == 0) first_missing = &state;
      continue;
    }
    ++wanted;
    auto best = begin;
    for (auto it = begin; it != end; ++it) {
      if (angleBetween(rotation(it->second), state.attitude) < angleBetween(rotation(best->second), state.attitude))
        best = it;
    }
    // Numbers that are not finite are another check's business.
    if (state.flaw.empty() && best->second.flaw.empty()) compare(state, best->second);
  }
  if (static_cast<double>(missing) > evidence.options.losses * static_cast<double>(wanted)) {
    judge.fail(seconds(first_missing->stamp),
               nearest(*first_missing, partners, what) + text(" (missing for %lld of %lld states)",
                                                              static_cast<long long>(missing),
                                                              static_cast<long long>(wanted)));
  }
}

std::string rotationWrong(const char* whose, const Eigen::Quaterniond& q, const State& state) {
  if (angleBetween(q, state.attitude.conjugate()) < 1e-9)
    return text("%s rotation is the inverse of the state's", whose);
  return text("%s rotation differs from the state's by %.3g rad", whose, angleBetween(q, state.attitude));
}

std::string positionWrong(const char* whose, const Eigen::Vector3d& p, const State& state) {
  return text("%s position differs from the state's by %.3g m", whose, (p - state.position).norm());
}

double positionBound(const State& state) {
  return 1e-12 * std::max(1.0, state.position.norm());
}

void judgeTf(const Evidence& evidence, std::vector<Check>& checks) {
  const Body& body = evidence.body;
  const auto rotation = [](const Transform& t) { return t.rotation; };
  Judge judge("tf = state", body.key, "rad, m");
  const std::multimap<Stamp, Transform> none;
  const auto* found = evidence.transforms.moving(body.frame);
  pairUp(evidence, found ? *found : none, "tf", judge, rotation, [&](const State& s, const Transform& t) {
    const double at = seconds(s.stamp);
    judge.compare(angleBetween(t.rotation, s.attitude), kAngle, at,
                  [&] { return rotationWrong("tf's", t.rotation, s); });
    judge.compare((t.translation - s.position).norm(), positionBound(s), at,
                  [&] { return positionWrong("tf's", t.translation, s); });
    if (t.parent != s.frame_id) {
      judge.fail(at, "tf places " + body.frame + " in " + t.parent + ", the state is in " + s.frame_id);
    }
  });
  checks.push_back(judge.verdict());

  // The turning frame of the picture comes with the picture.
  const std::string frame = body.frame + "_space_body";
  const auto* picture = evidence.transforms.moving(frame);
  if (!picture) return;
  Judge space("tf of space_body = state", body.key, "rad");
  pairUp(evidence, *picture, "tf of " + frame, space, rotation, [&](const State& s, const Transform& t) {
    space.compare(angleBetween(t.rotation, s.attitude), kAngle, seconds(s.stamp),
                  [&] { return rotationWrong("tf's", t.rotation, s); });
  });
  checks.push_back(space.verdict());
}

void judgeOdometry(const Evidence& evidence, std::vector<Check>& checks) {
  const Body& body = evidence.body;
  Judge pose("odometry = state", body.key, "rad, m"), twist("odometry twist in body axes", body.key);
  const auto rotation = [](const Odometry& o) { return o.attitude; };
  pairUp(evidence, body.odometry, "odometry", pose, rotation, [&](const State& s, const Odometry& o) {
    const double at = seconds(s.stamp);
    pose.compare(angleBetween(o.attitude, s.attitude), kAngle, at,
                 [&] { return rotationWrong("odometry's", o.attitude, s); });
    pose.compare((o.position - s.position).norm(), positionBound(s), at,
                 [&] { return positionWrong("odometry's", o.position, s); });
    const std::string& child = o.child_frame_id;
    const bool of_body = child.size() >= body.name.size() &&
                         child.compare(child.size() - body.name.size(), body.name.size(), body.name) == 0;
    if (!of_body) pose.fail(at, "odometry's child_frame_id is \"" + child + "\", not the frame of " + body.name);
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
