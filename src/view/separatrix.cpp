#include "poinsot/view/separatrix.h"

#include <cmath>

#include "even_spread.h"
#include "separatrix_plane.h"
#include "sorted_axes.h"

namespace poinsot::view {

std::vector<Curve> separatrix(const Eigen::Vector3d& moments, double kinetic_energy, int points_per_curve) {
  const SortedAxes axes(moments);
  if (!(kinetic_energy > 0) || !axes.allDiffer()) return {};
  // √(2E) for the scaled moments, so that √(2E/μ) stays the same.
  const double largest = moments[axes.index[2]];
  const double root = std::sqrt(2.0) * (std::sqrt(kinetic_energy) * (std::sqrt(axes.moment[2]) / std::sqrt(largest)));

  std::vector<Curve> curves;
  for (const double sign : {1.0, -1.0}) {
    curves.push_back(closedCurve(points_per_curve, SeparatrixPlane(axes, root, 1.0, sign)));
  }
  return curves;
}

}  // namespace poinsot::view
