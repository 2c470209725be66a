#include "poinsot/audit/free_motion.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace poinsot::audit {

namespace {
constexpr double kSubstepAngle = 0.005;  // rad, at the fastest rate
constexpr double kMostSubsteps = 50000;
}  // namespace

Eigen::Quaterniond rotationBy(const Eigen::Vector3d& theta) {
  const double half = 0.5 * theta.norm();
  const double s = half < 1e-4 ? 0.5 * (1 - half * half / 6) : 0.5 * std::sin(half) / half;
  Eigen::Quaterniond q;
  q.w() = std::cos(half);
  q.vec() = s * theta;
  return q.normalized();
}

Eigen::Vector3d rotationVector(const Eigen::Quaterniond& q) {
  const Eigen::Quaterniond p = q.w() < 0 ? Eigen::Quaterniond(-q.coeffs()) : q;
  const double s = p.vec().norm();
  if (s < 1e-12) return 2 * p.vec();
  return (2 * std::atan2(s, p.w()) / s) * p.vec();
}

Inertia::Inertia(const Eigen::Matrix3d& m) : tensor(m), inverse(m.inverse()) {
  moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m, Eigen::EigenvaluesOnly).eigenvalues();
}

double Inertia::partingRate(const Eigen::Vector3d& omega_body) const {
  const double curvature = (moments[2] - moments[1]) * (moments[1] - moments[0]) / (moments[0] * moments[2]);
  return (tensor * omega_body).norm() / moments[1] * std::sqrt(std::max(0.0, curvature));
}

double Inertia::conditionOfEnergy(const Eigen::Vector3d& omega_body) const {
  const double e = energy(omega_body);
  return e > 0 ? 0.5 * moments[2] * omega_body.squaredNorm() / e : 1;
}

double Inertia::conditionOfMomentum(const Eigen::Vector3d& omega_body) const {
  const double l = (tensor * omega_body).norm();
  return l > 0 ? moments[2] * omega_body.norm() / l : 1;
}

std::optional<FreeState> freeMotion(const Inertia& inertia, const FreeState& start, double duration) {
  const double substeps =
      std::max(1.0, std::ceil(inertia.fastestRate(start.omega_body) * std::abs(duration) / kSubstepAngle));
  if (!(substeps <= kMostSubsteps)) return std::nullopt;
  const double h = duration / substeps;

  struct Rate {
    Eigen::Vector4d q;  // x y z w
    Eigen::Vector3d p;  // Λ
  };
  const auto rateAt = [&inertia](const Eigen::Vector4d& q, const Eigen::Vector3d& p) {
    const Eigen::Vector3d w = inertia.inverse * p;
    const Eigen::Quaterniond product = Eigen::Quaterniond(q) * Eigen::Quaterniond(0, w.x(), w.y(), w.z());
    return Rate{0.5 * product.coeffs(), p.cross(w)};
  };
  Eigen::Vector4d q = start.attitude.coeffs();
  Eigen::Vector3d p = inertia.tensor * start.omega_body;
  for (int i = 0; i < static_cast<int>(substeps); ++i) {
    const Rate a = rateAt(q, p);
    const Rate b = rateAt(q + 0.5 * h * a.q, p + 0.5 * h * a.p);
    const Rate c = rateAt(q + 0.5 * h * b.q, p + 0.5 * h * b.p);
    const Rate d = rateAt(q + h * c.q, p + h * c.p);
    q += h / 6 * (a.q + 2 * b.q + 2 * c.q + d.q);
    p += h / 6 * (a.p + 2 * b.p + 2 * c.p + d.p);
  }
  return FreeState{Eigen::Quaterniond(q).normalized(), inertia.inverse * p};
}

double freeMotionError(const Inertia& inertia, const Eigen::Vector3d& omega_body, double duration) {
  const double angle = inertia.fastestRate(omega_body) * std::abs(duration);
  const double condition = inertia.moments[2] / inertia.moments[0];
  const double growth = std::exp(std::min(50.0, inertia.partingRate(omega_body) * std::abs(duration))) * (1 + angle);
  const double substeps = std::max(1.0, angle / kSubstepAngle);
  const double substep = std::min(angle, kSubstepAngle);
  return growth * (1e-15 * (10 + condition + std::sqrt(substeps)) + substeps * std::pow(substep, 5) / 30);
}

}  // namespace poinsot::audit
