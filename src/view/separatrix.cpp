#include "poinsot/view/separatrix.h"

#include "separatrix_plane.h"

namespace poinsot::view {

std::vector<Curve> separatrix(const Eigen::Vector3d& moments, double kinetic_energy, int points_per_curve) {
  const SortedAxes axes(moments);
  if (!(kinetic_energy > 0) || axes.moment[0] == axes.moment[1] || axes.moment[1] == axes.moment[2]) return {};
  // √(2E/μ) has to be the same for the scaled moments.
  const double largest = moments[axes.index[2]];
  const double root = std::sqrt(2.0) * (std::sqrt(kinetic_energy) * (std::sqrt(axes.moment[2]) / std::sqrt(largest)));

  std::vector<Curve> curves;
  for (const double sign : {1.0, -1.0}) {
    const SeparatrixPlane plane(axes, root, 1.0, sign);
    Curve curve{{}, true};
    for (const Direction& d : wholeTurn(evenQuarter(segmentsPerQuarter(points_per_curve), plane))) {
      curve.points.push_back(plane(d));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace poinsot::view
