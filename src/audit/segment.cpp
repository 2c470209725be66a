#include "segment.h"

#include <algorithm>
#include <cmath>

namespace poinsot::audit {

constexpr double kTooVague = 0.05;  // rad: a bound above this judges nothing

std::vector<Segment> segmentsOf(const Body& body) {
  std::vector<Segment> segments;
  for (std::size_t begin = 0, end; begin < body.states.size(); begin = end) {
    std::vector<const State*> states;
    for (end = begin; end < body.states.size() && body.states[end].segment == body.states[begin].segment; ++end) {
      if (body.states[end].flaw.empty()) states.push_back(&body.states[end]);
    }
    if (states.empty()) continue;
    const Description& d = *body.descriptionAt(states.back()->stamp);
    const auto rigid = std::make_shared<const RigidBody>(Inertia(d.tensor), d.forces);
    // Drifts refer to the first message: where that cannot be used, the segment counts as joined in its middle.
    Segment segment{states, &d, rigid, Bounds(d, *rigid, states), begin > 0 && body.states[begin].flaw.empty()};
    for (const State* s : states) {
      const Phase p = segment.phase(*s);
      segment.speed = std::max(segment.speed, rigid->speed(s->time, p));
      segment.momentum = std::max(segment.momentum, rigid->momentum(p).norm());
      segment.energy = std::max(segment.energy, rigid->energy(p));
    }
    segments.push_back(std::move(segment));
  }
  return segments;
}

double uncertainty(const Segment& segment, const State& a, double duration) {
  const RigidBody& body = *segment.body;
  const Phase start = segment.phase(a);
  const Eigen::Vector3d& moments = body.inertia().moments;
  const double substeps = body.substeps(a.time, start, duration, kFine);
  const double rate = body.rate(a.time, start), speed = body.speed(a.time, start);
  double u = 1e-15 * (10 + moments[2] / moments[0] + std::sqrt(substeps));
  u += std::min(substeps * kFineError, std::pow(rate * std::abs(duration), 5) / 30);
  if (!body.effects().turns) return u;
  u += segment.bounds.rounding(duration) + 4e-16 * rate * (std::abs(a.time) + std::abs(a.time + duration));
  if (const double j = body.slugInertia(); j > 0 && speed > 0) {
    u += 1e-15 * (a.momentum_world.norm() + moments[2] * start.omega.norm()) / (j * speed);
  }
  return u + segment.bounds.allowed(a, speed, duration);
}

std::optional<Followed> follow(const Segment& segment, const State& a, double duration) {
  const RigidBody& body = *segment.body;
  const Phase start = segment.phase(a);
  const double u = uncertainty(segment, a, duration), speed = body.speed(a.time, start), size = std::abs(duration);
  double attitude = u, omega = u;
  std::optional<Neighbours> neighbours;
  if (body.effects().turns) {
    if (!(u < kTooVague)) return std::nullopt;
    neighbours.emplace(body, a.time, start);
    if (!neighbours->travel(a.time, duration)) return std::nullopt;
    attitude *= 1 + neighbours->growth(attitudeDifference);
    if (speed > 0) omega *= 1 + neighbours->growth(omegaDifference) / speed;
  } else {
    const double parting = std::exp(std::min(50.0, body.inertia().partingRate(start.omega) * size));
    attitude = omega = u * parting * (1 + speed * size) + segment.bounds.allowed(a, speed, duration);
  }
  if (!(attitude < kTooVague)) return std::nullopt;
  const auto to = body.travel(a.time, start, duration, kFine);
  if (!to) return std::nullopt;
  return Followed{*to, u, attitude, omega, neighbours};
}

}  // namespace poinsot::audit
