#include "poinsot/core/torques.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "poinsot/core/effects/text.h"
#include "poinsot/core/number_text.h"
#include "poinsot/core/rotation.h"
#include "refuse.h"

namespace poinsot {
namespace {

constexpr std::size_t kMostFields = 3;
constexpr double kMostObliquity = 1e-9;  // cosine of the angle between directions that are called perpendicular

/** Returns v/|v|. @param name of v, for the message. */
Eigen::Vector3d direction(const Eigen::Vector3d& v, const char* name) {
  const double norm = v.stableNorm();
  if (norm > 0 && std::isfinite(norm)) return (v / norm).normalized();
  refuse(std::string(name) + ": expected a vector of finite length other than 0, got " + effects::text(v));
}

}  // namespace

Torques::Torques(const PrincipalInertia& inertia) : moments_(inertia.moments()), axes_(inertia.axes()) {}

void Torques::addBetween(double from, double to, Axes axes, const Eigen::Vector3d& torque) {
  if (!torque.allFinite()) refuse("torque: expected finite numbers (N·m), got " + effects::text(torque));
  if (!(from < to)) {
    refuse("expected a torque that ends after it begins, got one from " + effects::text(from) + " s to " +
           effects::text(to) + " s");
  }
  const auto cut = [this](double t) {
    if (!std::isfinite(t)) return;
    const auto place = std::lower_bound(switches_.begin(), switches_.end(), t);
    if (place != switches_.end() && *place == t) return;
    const auto k = place - switches_.begin();
    constants_.insert(constants_.begin() + k, Constant(constants_[k]));
    switches_.insert(place, t);
  };
  cut(from);
  cut(to);
  for (std::size_t k = 0; k < constants_.size(); ++k) {
    const double begin = k == 0 ? -std::numeric_limits<double>::infinity() : switches_[k - 1];
    const double end = k == switches_.size() ? std::numeric_limits<double>::infinity() : switches_[k];
    if (begin < from || end > to) continue;
    if (axes == Axes::body) {
      constants_[k].body += principal(torque);
    } else {
      constants_[k].world += torque;
    }
  }
  has_world_ = has_world_ || axes == Axes::world;
}

void Torques::addForce(const Eigen::Vector3d& lever, const Eigen::Vector3d& force_world) {
  if (!lever.allFinite() || !force_world.allFinite()) {
    refuse("expected a finite force and a finite lever, got " + effects::text(force_world) + " N at " +
           effects::text(lever) + " m");
  }
  const Eigen::Matrix3d map = hat(principal(lever));
  for (Field& field : fields_) {
    if (field.world != force_world) continue;
    field.map += map;
    return;
  }
  fields_.push_back({force_world, map});
  if (fields_.size() <= kMostFields) return;
  // Any number of forces can be written as three, one along each axis of the world.
  std::vector<Field> along_axes;
  for (int i = 0; i < 3; ++i) along_axes.push_back({Eigen::Vector3d::Unit(i), Eigen::Matrix3d::Zero()});
  for (const Field& field : fields_) {
    for (int i = 0; i < 3; ++i) along_axes[i].map += field.world[i] * field.map;
  }
  fields_ = along_axes;
}

void Torques::addGravityGradient(double orbit_rate, const Eigen::Vector3d& normal,
                                 const Eigen::Vector3d& radial_at_start) {
  if (gradient_) refuse("expected at most one orbit of a body, got a second");
  requirePositive(orbit_rate, "orbit_rate", "rad/s");
  const Eigen::Vector3d n = direction(normal, "orbit_normal"), given = direction(radial_at_start, "radial_at_start");
  if (!(std::abs(n.dot(given)) <= kMostObliquity)) {
    refuse("orbit_normal and radial_at_start must be perpendicular; the cosine of the angle between them is " +
           numberText(n.dot(given)));
  }
  const Eigen::Vector3d radial = (given - n.dot(given) * n).normalized();
  gradient_ = Gradient{orbit_rate, n, radial, n.cross(radial)};
}

void Torques::addDamping(const Eigen::Vector3d& coefficients) {
  if (!coefficients.allFinite() || !(coefficients.minCoeff() >= 0)) {
    refuse("coefficient: expected finite numbers (N·m·s) of at least 0, got " + effects::text(coefficients));
  }
  if (!damping_) damping_ = Eigen::Matrix3d::Zero();
  if (axes_.vec().isZero(0)) {
    damping_->diagonal() += coefficients;
    return;
  }
  const Eigen::Matrix3d p = axes_.conjugate().toRotationMatrix();
  *damping_ += p * coefficients.asDiagonal() * p.transpose();
}

void Torques::addSlug(double inertia, double damping) {
  if (slug_) refuse("expected at most one slug in a body, got a second");
  requirePositive(inertia, "slug_inertia", "kg·m²");
  if (!(damping >= 0) || !std::isfinite(damping)) {
    refuse("damping: expected a finite number (N·m·s) of at least 0, got " + effects::text(damping));
  }
  slug_ = Slug{inertia, damping};
}

void Torques::requireFinite() const {
  const double least = moments_.minCoeff(), most = moments_.maxCoeff();
  bool finite = true;
  for (const Constant& c : constants_) finite = finite && ((c.body + c.world) / least).allFinite();
  for (const Field& f : fields_) finite = finite && (f.map * (f.world.stableNorm() / least)).allFinite();
  if (gradient_) finite = finite && std::isfinite(3 * gradient_->rate * gradient_->rate * (most / least));
  if (damping_) finite = finite && (*damping_ / least).allFinite();
  if (slug_) {
    finite = finite && std::isfinite(slug_->damping / slug_->inertia) && std::isfinite(slug_->damping / least);
  }
  if (finite) return;
  refuse("the sum of the torques, or an acceleration that it gives, is not finite in double precision");
}

Eigen::Vector3d Torques::Gradient::radialAt(double t) const {
  return std::cos(rate * t) * radial + std::sin(rate * t) * along;
}

Eigen::Vector3d Torques::Gradient::alongAt(double t) const {
  return std::cos(rate * t) * along - std::sin(rate * t) * radial;
}

bool Torques::none() const {
  const bool constant = std::any_of(constants_.begin(), constants_.end(),
                                    [](const Constant& c) { return !c.body.isZero(0) || !c.world.isZero(0); });
  return !constant && fields_.empty() && !gradient_ && !damping_ && !slug_;
}

std::size_t Torques::intervalAt(double t) const {
  return static_cast<std::size_t>(std::upper_bound(switches_.begin(), switches_.end(), t) - switches_.begin());
}

bool Torques::momentumIsKnown() const {
  const bool in_body =
      std::any_of(constants_.begin(), constants_.end(), [](const Constant& c) { return !c.body.isZero(0); });
  return !in_body && fields_.empty() && !gradient_ && !damping_;
}

Eigen::Vector3d Torques::impulseWorld(double t) const {
  const double begin = std::min(0.0, t), end = std::max(0.0, t);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < constants_.size(); ++k) {
    const double from = k == 0 ? begin : std::max(begin, switches_[k - 1]);
    const double to = k == switches_.size() ? end : std::min(end, switches_[k]);
    if (to > from) sum += (to - from) * constants_[k].world;
  }
  return t < 0 ? Eigen::Vector3d(-sum) : sum;
}

Eigen::Vector3d Torques::at(double t, const Constant& constant, const Quaternion& attitude,
                            const Eigen::Vector3d& omega, const Eigen::Vector3d& slug_omega) const {
  Eigen::Vector3d torque = constant.body;
  if (has_world_) torque += attitude.conjugate() * constant.world;
  for (const Field& field : fields_) torque += field.map * (attitude.conjugate() * field.world);
  if (gradient_) {
    const Eigen::Vector3d u = attitude.conjugate() * gradient_->radialAt(t);
    torque += (3 * gradient_->rate * gradient_->rate) * u.cross(moments_.cwiseProduct(u));
  }
  if (damping_) torque -= *damping_ * omega;
  if (slug_) torque -= slug_->damping * (omega - slug_omega);
  return torque;
}

Eigen::Vector3d Torques::slugAcceleration(const Eigen::Vector3d& omega, const Eigen::Vector3d& slug_omega) const {
  if (!slug_) return Eigen::Vector3d::Zero();
  return (slug_->damping / slug_->inertia) * (omega - slug_omega) + slug_omega.cross(omega);
}

}  // namespace poinsot
