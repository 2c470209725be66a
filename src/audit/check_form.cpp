#include <Eigen/Eigenvalues>
#include <cmath>

#include "checks.h"

namespace poinsot::audit {
namespace {

constexpr double kUnit = 1e-12;    // of a quaternion's norm
constexpr double kFields = 1e-14;  // of fields that follow from others of the same message

/** Returns the transforms of the body's own frame and of that of its picture, where any were received. */
std::vector<std::pair<std::string, const Track<Transform>*>> framesOf(const Evidence& evidence) {
  std::vector<std::pair<std::string, const Track<Transform>*>> out;
  if (!evidence.options.tf || evidence.body.frame.empty()) return out;
  for (const std::string& frame : {evidence.body.frame, evidence.body.frame + "_space_body"}) {
    if (const auto* track = evidence.transforms.moving(frame)) out.emplace_back("tf of " + frame, track);
  }
  return out;
}

void judgeNumbers(const Evidence& evidence, std::vector<Check>& checks) {
  const Body& body = evidence.body;
  Judge finite("finite numbers", body.key), unit("unit quaternions", body.key);
  const auto look = [&](Stamp stamp, const Pose& pose, const std::string& where) {
    const Eigen::Quaterniond& q = pose.attitude_as_sent;
    finite.compare(pose.flaw.empty() ? 0 : 1, 0, seconds(stamp), [&] { return where + ": " + pose.flaw; });
    if (!q.coeffs().allFinite()) return;
    unit.compare(std::abs(1 - q.norm()), kUnit, seconds(stamp),
                 [&] { return text("%s: expected a unit quaternion, got the norm %.12g", where.c_str(), q.norm()); });
  };
  for (const State& s : body.states) look(s.stamp, s, "state");
  if (evidence.options.odometry) {
    for (const auto& [stamp, o] : body.odometry.by_stamp) look(stamp, o, "odometry");
  }
  for (const auto& [frame, track] : framesOf(evidence)) {
    for (const auto& [stamp, t] : track->by_stamp) look(stamp, t, frame);
  }
  checks.push_back(finite.verdict());
  checks.push_back(unit.verdict());
}

void judgeOrder(const Evidence& evidence, std::vector<Check>& checks) {
  const Body& body = evidence.body;
  Judge stamps("stamps never decrease", body.key), segments("segments never decrease", body.key);
  // A new segment begins where the clock jumps back; stamps of the other topics may go back as often, but no more.
  for (std::size_t i = 0; i < body.states.size(); ++i) {
    const State &a = body.states[i > 0 ? i - 1 : 0], &b = body.states[i];
    stamps.compare(b.stamp < a.stamp && b.segment <= a.segment ? 1 : 0, 0, seconds(b.stamp), [&] {
      return text("a state's stamp lies %.6f s before that of the previous state", seconds(a.stamp - b.stamp));
    });
    segments.compare(b.segment < a.segment ? 1 : 0, 0, seconds(b.stamp),
                     [&] { return text("segment %u comes after segment %u", b.segment, a.segment); });
  }
  const auto compare = [&](const std::string& what, std::int64_t backwards) {
    if (body.repeats || body.listed || backwards <= body.jumps) return;
    stamps.fail(
        0,
        text("%s: %lld stamps lie before the previous one", what.c_str(), static_cast<long long>(backwards)) +
            (body.jumps > 0 ? text(", and the clock jumped back %lld times", static_cast<long long>(body.jumps)) : ""));
  };
  if (evidence.options.odometry) compare("odometry", body.odometry.backwards);
  for (const auto& [frame, track] : framesOf(evidence)) compare(frame, track->backwards);
  if (body.repeats || body.listed) {
    stamps.note("the order of odometry and tf was not judged: states came twice, or were listed out of order");
  }
  checks.push_back(stamps.verdict());
  checks.push_back(segments.verdict());
}

/** Asks whether all effects can be read, and whether the method is one for such a body. */
void judgeEffects(const Evidence& evidence, std::vector<Check>& checks) {
  Judge judge("effects", evidence.body.key);
  for (const Description& d : evidence.body.descriptions) {
    const double at = seconds(d.stamp);
    judge.compare(d.forces.problem.empty() ? 0 : 1, 0, at, [&] { return d.forces.problem; });
    const bool needs_torques = d.method.rfind("taylor", 0) == 0 || d.method == "aba84";
    judge.compare(d.isFree() && needs_torques ? 1 : 0, 0, at,
                  [&] { return "method " + d.method + " needs torques, but the description names none"; });
    judge.compare(!d.isFree() && d.method == "closed_form" ? 1 : 0, 0, at,
                  [] { return "closed_form moves only free bodies, but the description names torques"; });
  }
  checks.push_back(judge.verdict());
}

}  // namespace

void judgeForm(const Evidence& evidence, std::vector<Check>& checks) {
  judgeNumbers(evidence, checks);
  judgeOrder(evidence, checks);
}

void judgeDescription(const Evidence& evidence, std::vector<Check>& checks) {
  Judge judge("description", evidence.body.key);
  judge.ifNothing("no description was received, so motion, energy and momentum could not be judged");
  for (const Description& d : evidence.body.descriptions) {
    const double at = seconds(d.stamp), largest = d.tensor.cwiseAbs().maxCoeff();
    if (!d.tensor.allFinite() || !(largest > 0)) {
      judge.compare(1, 0, at, [] { return "inertia_tensor: expected finite entries, not all of them 0"; });
      continue;
    }
    judge.compare((d.tensor - d.tensor.transpose()).cwiseAbs().maxCoeff() / largest, 1e-12, at,
                  [] { return "inertia_tensor is not symmetric"; });
    judge.compare(std::abs(1 - d.axes.norm()), kUnit, at, [] { return "principal_axes is not a unit quaternion"; });
    const Eigen::Matrix3d p = d.axes.normalized().toRotationMatrix();
    const Eigen::Matrix3d product = p * d.moments.asDiagonal() * p.transpose();
    judge.compare((product - d.tensor).cwiseAbs().maxCoeff() / largest, 1e-12, at, [&] {
      const Eigen::Matrix3d other = p.transpose() * d.moments.asDiagonal() * p;
      const bool inverse = (other - d.tensor).cwiseAbs().maxCoeff() < 1e-9 * largest;
      return std::string("inertia_tensor is not P diag(principal_moments) P'") +
             (inverse ? " (principal_axes looks like the inverse rotation)" : "");
    });
    judge.compare(Inertia(d.tensor).moments[0] > 0 ? 0 : 1, 0, at,
                  [] { return "inertia_tensor: expected positive principal moments"; });
  }
  checks.push_back(judge.verdict());
  if (!evidence.body.descriptions.empty()) judgeEffects(evidence, checks);
}

void judgeState(const Evidence& evidence, std::vector<Check>& checks) {
  const std::string& key = evidence.body.key;
  Judge omega("omega_world = R omega_body", key), momentum("momentum_world = R M omega_body", key),
      energy("kinetic_energy = 1/2 omega' M omega", key);
  const auto judge = [&](const Segment& segment, const State& s) {
    const Inertia& inertia = segment.body->inertia();
    const double at = seconds(s.stamp), rate = s.omega_body.norm();
    const Eigen::Vector3d l = s.attitude * (inertia.tensor * s.omega_body);
    const double e = inertia.energy(s.omega_body);
    // Errors are relative, but not those of a body at rest.
    const double omega_scale = rate > 0 ? rate : 1, l_scale = rate > 0 ? l.norm() : inertia.moments[2];
    const double e_scale = rate > 0 ? e : inertia.moments[2];
    omega.compare((s.omega_world - s.attitude * s.omega_body).norm() / omega_scale, kFields, at, [&] {
      const bool body_axes = (s.omega_world - s.omega_body).norm() < 1e-9 * omega_scale;
      const bool inverse = (s.omega_world - s.attitude.conjugate() * s.omega_body).norm() < 1e-9 * omega_scale;
      return std::string("omega_world is not R omega_body") + (body_axes ? " (it is omega_body)"
                                                               : inverse ? " (R looks inverted)"
                                                                         : "");
    });
    // With a slug inside, momentum_world is that of both, which judgeSlugsStart and dL/dt check.
    if (!segment.body->effects().slug)
      momentum.compare(
          (s.momentum_world - l).norm() / l_scale, kFields * inertia.conditionOfMomentum(s.omega_body), at, [&] {
            const bool body_axes = (s.momentum_world - inertia.tensor * s.omega_body).norm() < 1e-9 * l_scale;
            const bool world = (s.momentum_world - inertia.tensor * s.omega_world).norm() < 1e-9 * l_scale;
            return text("momentum_world is not R M omega_body%s; its length is %.6g times |M omega_body|",
                        body_axes ? " (it is in body axes)"
                        : world   ? " (it is M omega_world)"
                                  : "",
                        s.momentum_world.norm() / l_scale);
          });
    energy.compare(std::abs(s.kinetic_energy - e) / e_scale, kFields * inertia.conditionOfEnergy(s.omega_body), at,
                   [&] { return text("kinetic_energy is %.3f times ½ΩᵀMΩ", s.kinetic_energy / e_scale); });
  };
  for (const Segment& segment : evidence.segments) {
    for (const State* s : segment.states) judge(segment, *s);
  }
  checks.push_back(omega.verdict());
  if (momentum.count() > 0) checks.push_back(momentum.verdict());
  checks.push_back(energy.verdict());
}

}  // namespace poinsot::audit
