#include "poinsot/view/cones.h"

#include <cmath>

#include "sorted_axes.h"

namespace poinsot::view {

std::optional<Cones> cones(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal) {
  const SortedAxes axes(moments);
  const auto& m = axes.moment;
  if ((m[0] == m[1]) == (m[1] == m[2])) return std::nullopt;
  const int c = m[0] == m[1] ? 2 : 0;
  const double along = omega_principal[axes.index[c]];
  const double across = std::hypot(omega_principal[axes.index[1]], omega_principal[axes.index[2 - c]]);
  if (along == 0 || across == 0) return std::nullopt;

  Cones out;
  out.body_axis = std::copysign(1.0, along) * Eigen::Vector3d::Unit(axes.index[c]);
  out.body_angle = std::atan2(across, std::abs(along));
  // tan(θ − β), with tan θ = (A/C) tan β: no difference of nearly equal angles.
  out.space_angle =
      std::atan2(std::abs(m[1] - m[c]) * std::sin(out.body_angle) * std::cos(out.body_angle),
                 m[c] * std::pow(std::cos(out.body_angle), 2) + m[1] * std::pow(std::sin(out.body_angle), 2));
  out.around = c == 2;
  return out;
}

}  // namespace poinsot::view
