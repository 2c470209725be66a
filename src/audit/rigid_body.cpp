#include "rigid_body.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace poinsot::audit {
namespace {

constexpr double kMostSubsteps = 200000;
constexpr double kCoarse = 0.05;  // rad: substeps of neighbours, whose own errors cancel
constexpr int kMostTerms = 28;

/** A power series in time, of as many terms as are known so far. */
struct Series {
  int terms = kMostTerms;  // all terms of a constant are known
  std::array<double, kMostTerms> c{};

  Series() = default;
  Series(double value) { c[0] = value; }  // NOLINT: implicit, like conversions of numbers

  Series& operator+=(const Series& other) {
    terms = std::min(terms, other.terms);
    for (int k = 0; k < terms; ++k) c[k] += other.c[k];
    return *this;
  }
};

Series operator+(Series a, const Series& b) {
  return a += b;
}
Series operator*(double a, Series b) {
  for (double& term : b.c) term *= a;
  return b;
}
Series operator-(const Series& a, const Series& b) {
  return a + -1.0 * b;
}
Series operator-(const Series& a) {
  return -1.0 * a;
}
Series operator*(const Series& a, const Series& b) {
  Series out;
  out.terms = std::min(a.terms, b.terms);
  for (int k = 0; k < out.terms; ++k) {
    for (int i = 0; i <= k; ++i) out.c[k] += a.c[i] * b.c[k - i];
  }
  return out;
}

}  // namespace
}  // namespace poinsot::audit

namespace Eigen {
template <>
struct NumTraits<poinsot::audit::Series> : GenericNumTraits<double> {
  using Real = poinsot::audit::Series;
  using NonInteger = poinsot::audit::Series;
  using Nested = poinsot::audit::Series;
  enum { RequireInitialization = 1 };  // NOLINT(readability-identifier-naming): Eigen looks for this name
};
template <class Operation>
struct ScalarBinaryOpTraits<double, poinsot::audit::Series, Operation> {
  using ReturnType = poinsot::audit::Series;
};
}  // namespace Eigen

namespace poinsot::audit {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

template <class S>
using Vector3 = Eigen::Matrix<S, 3, 1>;

/** Derivatives with respect to time; that of the attitude is not a unit quaternion. */
template <class S>
struct Rates {
  PhaseOf<S> phase;
  Vector3<S> impulse;  ///< of external torques, world axes
  S work;
};

/** The sum of the constant torques that act at a time. */
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

/** Returns the right-hand side of the equations of motion, for numbers or power series. @param radial of each orbit,
 * world axes */
template <class S>
Rates<S> ratesOf(const Inertia& inertia, const Effects& effects, const Pushes& pushes,
                 const std::vector<Vector3<S>>& radial, const PhaseOf<S>& p) {
  const auto toBody = [back = p.attitude.conjugate()](const auto& v) -> Vector3<S> {
    return back._transformVector(v.template cast<S>());
  };
  Vector3<S> torque = pushes.body.cast<S>();
  if (!pushes.world.isZero(0)) torque += toBody(pushes.world);
  for (const Effects::Weight& weight : effects.weights) {
    torque += weight.centre.cross(toBody(Vector3d(weight.mass * weight.gravity)));
  }
  for (std::size_t i = 0; i < effects.orbits.size(); ++i) {
    const double n = effects.orbits[i].rate;
    const Vector3<S> u = toBody(radial[i]);
    torque += 3 * n * n * u.cross(inertia.tensor * u);
  }
  for (const Vector3d& damping : effects.dampings) torque += (-damping).cwiseProduct(p.omega);
  Rates<S> out;
  out.impulse = p.attitude._transformVector(torque);
  if (effects.slug) {
    const Vector3<S> drag = effects.slug->damping * (p.omega - p.slug_omega);
    torque = torque - drag;
    out.phase.slug_omega = 1 / effects.slug->inertia * drag - p.omega.cross(p.slug_omega);
  }
  out.work = p.omega.dot(torque);
  out.phase.omega = inertia.inverse * (Vector3<S>(inertia.tensor * p.omega).cross(p.omega) + torque);
  const Vector3<S> half = 0.5 * p.omega;
  out.phase.attitude.w() = -p.attitude.vec().dot(half);
  out.phase.attitude.vec() = p.attitude.w() * half + p.attitude.vec().cross(half);
  return out;
}

Phase moved(const Phase& p, double h, const Phase& rates) {
  return {Quaterniond(p.attitude.coeffs() + h * rates.attitude.coeffs()), p.omega + h * rates.omega,
          p.slug_omega + h * rates.slug_omega};
}

std::vector<Vector3d> radials(const Effects& effects, double t) {
  std::vector<Vector3d> out;
  for (const Effects::Orbit& orbit : effects.orbits) out.push_back(orbit.radialAt(t));
  return out;
}

/** Returns all numbers of a phase: four of the attitude, three of Ω, three of σ. */
std::array<Series*, 10> numbersOf(PhaseOf<Series>& p) {
  std::array<Series*, 10> out{};
  for (int i = 0; i < 4; ++i) out[i] = &p.attitude.coeffs()[i];
  for (int i = 0; i < 3; ++i) {
    out[4 + i] = &p.omega[i];
    out[7 + i] = &p.slug_omega[i];
  }
  return out;
}

}  // namespace

Quaterniond rotationBy(const Vector3d& theta) {
  return Quaterniond(Eigen::AngleAxisd(theta.stableNorm(), theta.stableNormalized()));
}

Vector3d rotationVector(const Quaterniond& q) {
  const Eigen::AngleAxisd turn(q);
  return turn.angle() * turn.axis();
}

Inertia::Inertia(const Eigen::Matrix3d& m) : tensor(m), inverse(m.inverse()) {
  moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m, Eigen::EigenvaluesOnly).eigenvalues();
}

double Inertia::partingRate(const Vector3d& omega_body) const {
  const double curvature = (moments[2] - moments[1]) * (moments[1] - moments[0]) / (moments[0] * moments[2]);
  return (tensor * omega_body).norm() / moments[1] * std::sqrt(std::max(0.0, curvature));
}

double Inertia::conditionOfEnergy(const Vector3d& omega_body) const {
  const double e = energy(omega_body);
  return e > 0 ? 0.5 * moments[2] * omega_body.squaredNorm() / e : 1;
}

double Inertia::conditionOfMomentum(const Vector3d& omega_body) const {
  const double l = (tensor * omega_body).norm();
  return l > 0 ? moments[2] * omega_body.norm() / l : 1;
}

Vector3d RigidBody::momentum(const Phase& p) const {
  return p.attitude * Vector3d(inertia_.tensor * p.omega + slugInertia() * p.slug_omega);
}

double RigidBody::torqueScale(double t, const Phase& p) const {
  if (!effects_.turns) return 0;
  double torque = ratesOf(inertia_, effects_, pushesAt(effects_, t), radials(effects_, t), p).impulse.norm();
  for (const Effects::Weight& w : effects_.weights) torque += w.mass * w.gravity.norm() * w.centre.norm();
  for (const Effects::Orbit& o : effects_.orbits) torque += 3 * o.rate * o.rate * inertia_.moments[2];
  return torque;
}

double RigidBody::speed(double t, const Phase& p) const {
  const double rate = inertia_.fastestRate(p.omega) + std::sqrt(torqueScale(t, p) / inertia_.moments[0]);
  return effects_.slug ? std::max(rate, p.slug_omega.norm()) : rate;
}

double RigidBody::rate(double t, const Phase& p) const {
  double rate = speed(t, p), damping = 0;
  for (const Effects::Orbit& o : effects_.orbits) rate += o.rate;
  for (const Vector3d& d : effects_.dampings) damping += d.maxCoeff();
  if (effects_.slug) {
    damping += effects_.slug->damping;
    rate += effects_.slug->damping / effects_.slug->inertia;
  }
  return rate + damping / inertia_.moments[0];
}

double RigidBody::substeps(double t, const Phase& start, double duration, double angle) const {
  return std::max(1.0, std::ceil(rate(t, start) * std::abs(duration) / angle));
}

std::optional<Travelled> RigidBody::travel(double t, const Phase& start, double duration, double angle) const {
  // Between the times at which something is switched.
  std::vector<double> times = {t, t + duration};
  for (const Effects::Push& push : effects_.pushes) {
    for (const double s : {push.from, push.to}) {
      if (s > std::min(t, t + duration) && s < std::max(t, t + duration)) times.push_back(s);
    }
  }
  std::sort(times.begin(), times.end());
  if (duration < 0) std::reverse(times.begin(), times.end());

  Travelled out{start, Vector3d::Zero(), 0};
  Phase& p = out.end;
  double taken = 0;
  for (std::size_t piece = 1; piece < times.size(); ++piece) {
    // Differences of the times are rounded; a single piece takes the duration itself.
    const double from = times[piece - 1], length = times.size() == 2 ? duration : times[piece] - from;
    if (length == 0) continue;
    const double count = substeps(from + 0.5 * length, p, length, angle), h = length / count;
    taken += count;
    if (!(taken <= kMostSubsteps)) return std::nullopt;
    const Pushes pushes = pushesAt(effects_, from + 0.5 * length);
    for (int i = 0; i < static_cast<int>(count); ++i) {
      const double begin = from + i * h;
      const auto middle = radials(effects_, begin + 0.5 * h);
      const auto a = ratesOf(inertia_, effects_, pushes, radials(effects_, begin), p);
      const auto b = ratesOf(inertia_, effects_, pushes, middle, moved(p, 0.5 * h, a.phase));
      const auto c = ratesOf(inertia_, effects_, pushes, middle, moved(p, 0.5 * h, b.phase));
      const auto d = ratesOf(inertia_, effects_, pushes, radials(effects_, begin + h), moved(p, h, c.phase));
      for (const auto& [weight, rates] : {std::pair(1 / 6., &a), {1 / 3., &b}, {1 / 3., &c}, {1 / 6., &d}}) {
        p = moved(p, weight * h, rates->phase);
        out.impulse += weight * h * rates->impulse;
        out.work += weight * h * rates->work;
      }
      p.attitude.normalize();
    }
  }
  if (!p.omega.allFinite() || !p.attitude.coeffs().allFinite()) return std::nullopt;
  return out;
}

std::vector<double> RigidBody::taylorTerms(double t, const Phase& p, double h, int count) const {
  const double speed = this->speed(t, p);
  std::vector<Vector3<Series>> radial;
  for (const Effects::Orbit& orbit : effects_.orbits) {
    const Vector3d r = orbit.radialAt(t), along = orbit.normal.cross(r);
    Vector3<Series>& series = radial.emplace_back();
    double factor = 1;  // (nh)ᵏ/k!
    for (int k = 0; k < kMostTerms; ++k) {
      const double sign = k % 4 < 2 ? 1 : -1;
      for (int i = 0; i < 3; ++i) series[i].c[k] = sign * factor * (k % 2 == 0 ? r[i] : along[i]);
      factor *= orbit.rate * h / (k + 1);
    }
  }
  PhaseOf<Series> x{p.attitude.cast<Series>(), p.omega.cast<Series>(), p.slug_omega.cast<Series>()};
  const auto numbers = numbersOf(x);
  for (Series* number : numbers) number->terms = 1;
  const Pushes pushes = pushesAt(effects_, t);
  std::vector<double> terms = {1};
  for (int k = 0; k + 1 < count; ++k) {
    Rates<Series> rates = ratesOf(inertia_, effects_, pushes, radial, x);
    const auto rate = numbersOf(rates.phase);
    double squares[] = {0, 0, 0};  // of the attitude, Ω and σ
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double next = h * rate[i]->c[k] / (k + 1);
      numbers[i]->c[k + 1] = next;
      numbers[i]->terms = k + 2;
      squares[i < 4 ? 0 : i < 7 ? 1 : 2] += next * next;
    }
    const double fastest = std::sqrt(std::max(squares[1], squares[2]));
    terms.push_back(std::max(2 * std::sqrt(squares[0]), speed > 0 ? fastest / speed : 0));
  }
  return terms;
}

Neighbours::Neighbours(const RigidBody& body, double t, const Phase& start) : body_(&body), phases_{start} {
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
    const auto there = body_->travel(t, p, duration, kCoarse);
    if (!there) return false;
    p = there->end;
  }
  return true;
}

}  // namespace poinsot::audit
