#include "poinsot/audit/driven_motion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "poinsot/audit/recording.h"

namespace poinsot::audit {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kMostSubsteps = 200000;
constexpr double kCoarse = 0.05;  // rad: neighbours are only compared with each other
constexpr int kMostTerms = 28;

/** A power series in time, of as many terms as are known so far. */
struct Series {
  int terms = kMostTerms;  // of a constant all are known
  std::array<double, kMostTerms> c{};

  Series() = default;
  Series(double value) { c[0] = value; }  // NOLINT: as numbers convert
};

Series operator+(const Series& a, const Series& b) {
  Series out;
  out.terms = std::min(a.terms, b.terms);
  for (int k = 0; k < out.terms; ++k) out.c[k] = a.c[k] + b.c[k];
  return out;
}
Series operator*(const Series& a, const Series& b) {
  Series out;
  out.terms = std::min(a.terms, b.terms);
  for (int k = 0; k < out.terms; ++k) {
    for (int i = 0; i <= k; ++i) out.c[k] += a.c[i] * b.c[k - i];
  }
  return out;
}
Series operator*(double a, const Series& b) {
  Series out = b;
  for (double& c : out.c) c *= a;
  return out;
}
Series operator-(const Series& a, const Series& b) {
  return a + -1.0 * b;
}

template <class S>
using Three = std::array<S, 3>;

template <class S>
Three<S> operator+(const Three<S>& a, const Three<S>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class S>
Three<S> operator-(const Three<S>& a, const Three<S>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class S, class Factor>
Three<S> scaled(const Factor& f, const Three<S>& a) {
  return {f * a[0], f * a[1], f * a[2]};
}
template <class S>
S dot(const Three<S>& a, const Three<S>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class S>
Three<S> cross(const Three<S>& a, const Three<S>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class S>
Three<S> times(const Eigen::Matrix3d& m, const Three<S>& v) {
  Three<S> out;
  for (int i = 0; i < 3; ++i) out[i] = m(i, 0) * v[0] + m(i, 1) * v[1] + m(i, 2) * v[2];
  return out;
}
template <class S>
Three<S> constant(const Vector3d& v) {
  return {S(v[0]), S(v[1]), S(v[2])};
}

/** A rotation's parts, unit. */
template <class S>
struct Turned {
  S w;
  Three<S> v;

  Three<S> toWorld(const Three<S>& x) const {
    const Three<S> c = scaled(2.0, cross(v, x));
    return x + scaled(w, c) + cross(v, c);
  }
  Three<S> toBody(const Three<S>& x) const {
    const Three<S> c = scaled(2.0, cross(v, x));
    return x - scaled(w, c) + cross(v, c);
  }
};

template <class S>
struct Point {
  Turned<S> q;
  Three<S> omega, slug;
};

template <class S>
struct Rates {
  S w;
  Three<S> v, omega, slug;
  Three<S> impulse;  // of external torques, world axes
  S work;
};

/** The constant torques that act at a time, summed up. */
struct Pushes {
  Vector3d body = Vector3d::Zero(), world = Vector3d::Zero();
};

Pushes pushesAt(const Effects& effects, double t) {
  Pushes out;
  for (const Effects::Push& p : effects.pushes) {
    if (t >= p.from && t < p.to) (p.world ? out.world : out.body) += p.torque;
  }
  return out;
}

/** The equations of motion; for numbers, and for power series. @param radial of each orbit, world axes */
template <class S>
Rates<S> ratesOf(const Inertia& inertia, const Effects& effects, const Pushes& pushes,
                 const std::vector<Three<S>>& radial, const Point<S>& p) {
  Three<S> torque = constant<S>(pushes.body);
  if (!pushes.world.isZero(0)) torque = torque + p.q.toBody(constant<S>(pushes.world));
  for (const Effects::Weight& weight : effects.weights) {
    const Vector3d force = weight.mass * weight.gravity;
    torque = torque + cross(constant<S>(weight.centre), p.q.toBody(constant<S>(force)));
  }
  for (std::size_t i = 0; i < effects.orbits.size(); ++i) {
    const double n = effects.orbits[i].rate;
    const Three<S> u = p.q.toBody(radial[i]);
    torque = torque + scaled(3 * n * n, cross(u, times(inertia.tensor, u)));
  }
  for (const Vector3d& damping : effects.dampings) {
    for (int i = 0; i < 3; ++i) torque[i] = torque[i] - damping[i] * p.omega[i];
  }
  Rates<S> out;
  out.impulse = p.q.toWorld(torque);
  out.slug = constant<S>(Vector3d::Zero());
  if (effects.slug) {
    const Three<S> drag = scaled(effects.slug->damping, p.omega - p.slug);
    torque = torque - drag;
    out.slug = scaled(1 / effects.slug->inertia, drag) - cross(p.omega, p.slug);
  }
  out.work = dot(p.omega, torque);
  out.omega = times(inertia.inverse, cross(times(inertia.tensor, p.omega), p.omega) + torque);
  const Three<S> half = scaled(0.5, p.omega);
  out.w = -1.0 * dot(p.q.v, half);
  out.v = scaled(p.q.w, half) + cross(p.q.v, half);
  return out;
}

Point<double> pointOf(const Phase& p) {
  const auto three = [](const Vector3d& v) { return Three<double>{v[0], v[1], v[2]}; };
  return {{p.attitude.w(), three(p.attitude.vec())}, three(p.omega), three(p.slug_omega)};
}

Vector3d vectorOf(const Three<double>& v) {
  return {v[0], v[1], v[2]};
}

Point<double> moved(const Point<double>& p, double h, const Rates<double>& r) {
  return {{p.q.w + h * r.w, p.q.v + scaled(h, r.v)}, p.omega + scaled(h, r.omega), p.slug + scaled(h, r.slug)};
}

std::vector<Three<double>> radials(const Effects& effects, double t) {
  std::vector<Three<double>> out;
  for (const Effects::Orbit& orbit : effects.orbits) {
    const Vector3d r = orbit.radialAt(t);
    out.push_back({r[0], r[1], r[2]});
  }
  return out;
}

}  // namespace

Vector3d DrivenBody::momentum(const Phase& p) const {
  Vector3d body = inertia_.tensor * p.omega;
  if (effects_.slug) body += effects_.slug->inertia * p.slug_omega;
  return p.attitude * body;
}

double DrivenBody::torqueScale(double t, const Phase& p) const {
  const Rates<double> rates = ratesOf(inertia_, effects_, pushesAt(effects_, t), radials(effects_, t), pointOf(p));
  double torque = vectorOf(rates.impulse).norm();
  for (const Effects::Weight& w : effects_.weights) torque += w.mass * w.gravity.norm() * w.centre.norm();
  for (const Effects::Orbit& o : effects_.orbits) torque += 3 * o.rate * o.rate * inertia_.moments[2];
  return torque;
}

double DrivenBody::speed(double t, const Phase& p) const {
  const double rate = inertia_.fastestRate(p.omega) + std::sqrt(torqueScale(t, p) / inertia_.moments[0]);
  return effects_.slug ? std::max(rate, p.slug_omega.norm()) : rate;
}

double DrivenBody::rate(double t, const Phase& p) const {
  double rate = speed(t, p), damping = 0;
  for (const Effects::Orbit& o : effects_.orbits) rate += o.rate;
  for (const Vector3d& d : effects_.dampings) damping += d.maxCoeff();
  if (effects_.slug) {
    damping += effects_.slug->damping;
    rate += effects_.slug->damping / effects_.slug->inertia;
  }
  return rate + damping / inertia_.moments[0];
}

double DrivenBody::substeps(double t, const Phase& start, double duration, double angle) const {
  return std::max(1.0, std::ceil(rate(t, start) * std::abs(duration) / angle));
}

std::optional<Travelled> DrivenBody::travel(double t, const Phase& start, double duration, double angle) const {
  // Between the times at which something is switched.
  std::vector<double> times = {t, t + duration};
  for (const Effects::Push& push : effects_.pushes) {
    for (const double s : {push.from, push.to}) {
      if (s > std::min(t, t + duration) && s < std::max(t, t + duration)) times.push_back(s);
    }
  }
  std::sort(times.begin(), times.end());
  if (duration < 0) std::reverse(times.begin(), times.end());

  Point<double> p = pointOf(start);
  Vector3d impulse = Vector3d::Zero();
  double work = 0, taken = 0;
  for (std::size_t piece = 1; piece < times.size(); ++piece) {
    const double from = times[piece - 1], length = times[piece] - from;
    if (length == 0) continue;
    const Phase now{Quaterniond(p.q.w, p.q.v[0], p.q.v[1], p.q.v[2]), vectorOf(p.omega), vectorOf(p.slug)};
    const double count = substeps(from + 0.5 * length, now, length, angle), h = length / count;
    taken += count;
    if (!(taken <= kMostSubsteps)) return std::nullopt;
    const Pushes pushes = pushesAt(effects_, from + 0.5 * length);
    for (int i = 0; i < static_cast<int>(count); ++i) {
      const double begin = from + i * h;
      const auto middle = radials(effects_, begin + 0.5 * h);
      const auto a = ratesOf(inertia_, effects_, pushes, radials(effects_, begin), p);
      const auto b = ratesOf(inertia_, effects_, pushes, middle, moved(p, 0.5 * h, a));
      const auto c = ratesOf(inertia_, effects_, pushes, middle, moved(p, 0.5 * h, b));
      const auto d = ratesOf(inertia_, effects_, pushes, radials(effects_, begin + h), moved(p, h, c));
      for (const auto& [weight, rates] : {std::pair(1 / 6., &a), {1 / 3., &b}, {1 / 3., &c}, {1 / 6., &d}}) {
        p = moved(p, weight * h, *rates);
        impulse += weight * h * vectorOf(rates->impulse);
        work += weight * h * rates->work;
      }
      const double norm = std::sqrt(p.q.w * p.q.w + dot(p.q.v, p.q.v));
      p.q = {p.q.w / norm, scaled(1 / norm, p.q.v)};
    }
  }
  const Phase end{Quaterniond(p.q.w, p.q.v[0], p.q.v[1], p.q.v[2]).normalized(), vectorOf(p.omega), vectorOf(p.slug)};
  if (!end.omega.allFinite() || !end.attitude.coeffs().allFinite()) return std::nullopt;
  return Travelled{end, impulse, work};
}

std::vector<double> DrivenBody::taylorTerms(double t, const Phase& p, double h, int count) const {
  const double speed = this->speed(t, p);
  std::vector<Three<Series>> radial;
  for (const Effects::Orbit& orbit : effects_.orbits) {
    const Vector3d r = orbit.radialAt(t), along = orbit.normal.cross(r);
    Three<Series> series;
    for (int i = 0; i < 3; ++i) {
      double factor = 1;  // (nh)ᵏ/k!
      for (int k = 0; k < kMostTerms; ++k) {
        const double sign = k % 4 < 2 ? 1 : -1;
        series[i].c[k] = sign * factor * (k % 2 == 0 ? r[i] : along[i]);
        factor *= orbit.rate * h / (k + 1);
      }
    }
    radial.push_back(series);
  }
  const Point<double> at = pointOf(p);
  Point<Series> x;
  const auto begin = [](Series& s, double value) {
    s = Series(value);
    s.terms = 1;
  };
  begin(x.q.w, at.q.w);
  for (int i = 0; i < 3; ++i) {
    begin(x.q.v[i], at.q.v[i]);
    begin(x.omega[i], at.omega[i]);
    begin(x.slug[i], at.slug[i]);
  }
  const Pushes pushes = pushesAt(effects_, t);
  std::vector<double> terms = {1};
  for (int k = 0; k + 1 < count; ++k) {
    const Rates<Series> rates = ratesOf(inertia_, effects_, pushes, radial, x);
    double q = 0, omega = 0, slug = 0;
    const auto next = [k, h](Series& s, const Series& rate, double& square) {
      s.c[k + 1] = h * rate.c[k] / (k + 1);
      s.terms = k + 2;
      square += s.c[k + 1] * s.c[k + 1];
    };
    next(x.q.w, rates.w, q);
    for (int i = 0; i < 3; ++i) {
      next(x.q.v[i], rates.v[i], q);
      next(x.omega[i], rates.omega[i], omega);
      next(x.slug[i], rates.slug[i], slug);
    }
    terms.push_back(std::max(2 * std::sqrt(q), speed > 0 ? std::sqrt(std::max(omega, slug)) / speed : 0));
  }
  return terms;
}

Neighbours::Neighbours(const DrivenBody& body, double t, const Phase& start) : body_(body), phases_{start} {
  const double speed = body.speed(t, start);
  for (int i = 0; i < 3; ++i) {
    Phase p = start;
    p.attitude = p.attitude * rotationBy(kOff * Vector3d::Unit(i));
    phases_.push_back(p);
    p = start;
    p.omega[i] += kOff * speed;
    phases_.push_back(p);
    if (!body.effects().slug) continue;
    p = start;
    p.slug_omega[i] += kOff * speed;
    phases_.push_back(p);
  }
}

bool Neighbours::travel(double t, double duration) {
  for (Phase& p : phases_) {
    const auto there = body_.travel(t, p, duration, kCoarse);
    if (!there) return false;
    p = there->end;
  }
  return true;
}

}  // namespace poinsot::audit
