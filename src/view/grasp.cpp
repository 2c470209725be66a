#include "poinsot/view/grasp.h"

#include <cmath>

namespace poinsot::view {

std::optional<Eigen::Vector3d> pointTowards(const Eigen::Vector3d& semi_axes, const Eigen::Vector3d& point) {
  if (!point.allFinite()) return std::nullopt;
  const double largest = point.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return std::nullopt;
  // Scaled to order one, because squares of values from outside may leave the range of doubles.
  const Eigen::Vector3d u = (point / largest).cwiseQuotient(semi_axes / semi_axes.maxCoeff());
  return semi_axes.cwiseProduct(u.stableNormalized());
}

std::optional<Eigen::Vector3d> pointInSight(const Eigen::Vector3d& semi_axes, const Eigen::Vector3d& eye,
                                            const Eigen::Vector3d& point) {
  const Eigen::Vector3d sight = point - eye;
  if (!sight.allFinite() || sight.isZero(0)) return std::nullopt;
  const Eigen::Vector3d e = eye.cwiseQuotient(semi_axes);
  if (!(e.squaredNorm() > 1)) return pointTowards(semi_axes, point);
  // In coordinates in which it is the unit sphere.
  const Eigen::Vector3d d = sight.stableNormalized().cwiseQuotient(semi_axes).stableNormalized();
  const double along = -e.dot(d);  // from the eye to where the line comes nearest to the centre
  if (!(along > 0)) return pointTowards(semi_axes, point);  // behind the eye
  const Eigen::Vector3d nearest = e + along * d;
  const double deficit = 1 - nearest.squaredNorm();
  if (deficit > 0) return semi_axes.cwiseProduct((nearest - std::sqrt(deficit) * d).normalized());
  // On the rim, where a line of sight in the same plane touches the ellipsoid.
  const double distance = e.stableNorm();
  const Eigen::Vector3d aside = d - d.dot(e / distance) * (e / distance);
  const double lean = 1 / distance;
  return semi_axes.cwiseProduct(lean * (e / distance) + std::sqrt(1 - lean * lean) * aside.stableNormalized());
}

}  // namespace poinsot::view
