#include "poinsot/view/polhode_family.h"

#include <algorithm>
#include <cmath>

#include "even_spread.h"
#include "poinsot/core/pi.h"
#include "poinsot/view/polhode.h"
#include "poinsot/view/separatrix.h"
#include "sorted_axes.h"

namespace poinsot::view {
namespace {

constexpr double kQuarter = kPi / 2;
constexpr int kFine = 512;

/** The section of the momentum ellipsoid, longest semi-axis 1, by the plane of axes 1 and 3. */
class Meridian {
 public:
  explicit Meridian(const SortedAxes& axes) : axes_(axes), long_(1), short_(axes.moment[0] / axes.moment[2]) {
    length_.resize(kFine + 1);
    for (int i = 1; i <= kFine; ++i) length_[i] = length_[i - 1] + (at(angle(i)) - at(angle(i - 1))).norm();
  }

  /** Returns the point at an angle, 0 at the end of axis 1 and π/2 at that of axis 3; in the caller's order of axes. */
  Eigen::Vector3d at(double angle) const {
    return axes_.inCallersOrder({long_ * std::cos(angle), 0, short_ * std::sin(angle)});
  }

  double lengthTo(double angle) const {
    const double place = std::clamp(angle / kQuarter, 0.0, 1.0) * kFine;
    const int i = std::min(kFine - 1, static_cast<int>(place));
    return length_[i] + (place - i) * (length_[i + 1] - length_[i]);
  }
  double angleAfter(double length) const {
    const auto next = std::lower_bound(length_.begin() + 1, length_.end() - 1, length);
    const auto i = static_cast<int>(next - length_.begin());
    const double piece = *next - *(next - 1);
    return angle(i - 1) + (piece > 0 ? (length - *(next - 1)) / piece : 0) * kQuarter / kFine;
  }
  double length() const { return length_.back(); }

 private:
  static double angle(int i) { return kQuarter * i / kFine; }

  SortedAxes axes_;
  double long_, short_;
  std::vector<double> length_;
};

/** Returns how many points an ellipse with a semi-axis of at most `radius` needs. */
int pointsFor(double radius, double tolerance) {
  return static_cast<int>(pointsOfCircle(radius, tolerance));
}

void scale(std::vector<Curve>& curves, double factor) {
  for (Curve& curve : curves) {
    for (Eigen::Vector3d& p : curve.points) p *= factor;
  }
}

}  // namespace

PolhodeFamily polhodeFamily(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal, double spacing,
                            double tolerance) {
  PolhodeFamily out;
  const SortedAxes axes(moments);
  const auto& m = axes.moment;
  const double largest = omega_principal.cwiseAbs().maxCoeff();
  if (!(largest > 0) || m[0] == m[2]) return out;
  const Meridian meridian(axes);
  // Λ scaled to |Λ| = μmin, so that the longest semi-axis |Λ|/μmin is 1; `unit` is that semi-axis.
  Eigen::Vector3d momentum = axes.sorted(moments).cwiseProduct(axes.sorted(omega_principal) / largest);
  const double unit = (momentum.stableNorm() / moments.minCoeff()) * largest;
  momentum *= m[0] / momentum.stableNorm();

  // A polhode crosses the section at a place given by e = (2E − F/μ₃)/(F/μ₁ − F/μ₃), 1 at the end of axis 1 and 0 at
  // that of axis 3: there Λ₁² = F e. On the separatrix 2E = F/μ₂.
  const auto crossing = [](double e) { return std::acos(std::sqrt(std::clamp(e, 0.0, 1.0))); };
  const double i21 = m[0] * (m[2] - m[1]) / (m[1] * (m[2] - m[0]));  // e of the separatrix
  const double share1 = std::pow(momentum[0] / m[0], 2), share2 = std::pow(momentum[1] / m[0], 2);
  const double own = meridian.lengthTo(crossing(share1 + share2 * i21));
  const double border = meridian.lengthTo(crossing(i21));

  const auto add = [&](double begin, double end) {
    if (!(end - begin > 0)) return;
    const int steps = std::max(2, static_cast<int>(std::round((end - begin) / spacing)));
    const double step = (end - begin) / steps;
    for (int k = 1; k < steps; ++k) {
      const double place = begin + k * step;
      if (std::abs(place - own) < 0.5 * step) continue;
      const Eigen::Vector3d start = meridian.at(meridian.angleAfter(place));
      const Polhode coarse = polhode(moments, start, 8);
      double size = 0;
      for (const Curve& branch : coarse.branches) {
        for (const Eigen::Vector3d& p : branch.points) {
          size = std::max(size, 0.5 * (p - branch.points.front()).norm());
        }
      }
      for (Curve& branch : polhode(moments, start, pointsFor(size, tolerance)).branches) {
        if (branch.closed) out.members.push_back(std::move(branch));
      }
    }
  };
  if (m[1] < m[2]) add(0, m[0] < m[1] ? border : meridian.length());
  if (m[0] < m[1]) add(m[1] < m[2] ? border : 0, meridian.length());
  scale(out.members, unit);

  if (axes.allDiffer()) {
    // On the separatrix 2E = F/μ₂; here F = μmin².
    const double smallest = moments.minCoeff();
    out.separatrix = separatrix(moments, 0.5 * smallest * (m[0] / m[1]), pointsFor(1, tolerance));
    scale(out.separatrix, unit);
  }
  return out;
}

}  // namespace poinsot::view
