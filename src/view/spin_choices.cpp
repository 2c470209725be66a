#include "poinsot/view/spin_choices.h"

#include <cmath>
#include <stdexcept>

#include "poinsot/core/pi.h"
#include "poinsot/view/ellipsoids.h"
#include "poinsot/view/grasp.h"
#include "separatrix_plane.h"
#include "sorted_axes.h"

namespace poinsot::view {
namespace {

constexpr double kDegree = kPi / 180;
constexpr double kNearStableAxis = 12 * kDegree;
constexpr double kNearUnstableAxis = 1.5 * kDegree;
constexpr double kAlongSeparatrix = 15 * kDegree;
constexpr int kUlps = 64;  // units in the last place within which the place nearest to the separatrix is looked for

double signOf(double x) {
  return x < 0 ? -1 : 1;
}

/** Returns how far Ω is off the separatrix, with more digits than a double has. */
long double residual(const SortedAxes& axes, const Eigen::Vector3d& omega) {
  const long double i1 = axes.moment[0], i2 = axes.moment[1], i3 = axes.moment[2];
  const long double o1 = omega[axes.index[0]], o3 = omega[axes.index[2]];
  return std::abs(i3 * (i3 - i2) * o3 * o3 - i1 * (i2 - i1) * o1 * o1);
}

}  // namespace

Eigen::Vector3d keptSemiAxes(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega, ConservedQuantity keep) {
  const double unit = omega.cwiseAbs().maxCoeff();  // squares stay in the range of doubles
  const Eigen::Vector3d o = omega / unit;
  const Eigen::Vector3d m = moments / moments.maxCoeff();
  const Eigen::Vector3d axes = keep == ConservedQuantity::energy ? energySemiAxes(m, 0.5 * o.dot(m.cwiseProduct(o)))
                                                                 : momentumSemiAxes(m, m.cwiseProduct(o).squaredNorm());
  return unit * axes;
}

Eigen::Vector3d axisSpin(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega, ConservedQuantity keep,
                         Axis axis) {
  const int i = SortedAxes(moments).index[static_cast<int>(axis)];
  Eigen::Vector3d out = Eigen::Vector3d::Zero();
  out[i] = signOf(omega[i]) * keptSemiAxes(moments, omega, keep)[i];
  return out;
}

Eigen::Vector3d nearAxis(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega, ConservedQuantity keep,
                         Axis axis) {
  const SortedAxes axes(moments);
  const bool unstable = axis == Axis::intermediate;
  const double angle = unstable ? kNearUnstableAxis : kNearStableAxis;
  const int about = axes.index[static_cast<int>(axis)], towards = axes.index[unstable ? 2 : 1];
  Eigen::Vector3d u = Eigen::Vector3d::Zero();
  u[about] = signOf(omega[about]) * std::cos(angle);
  u[towards] = signOf(omega[towards]) * std::sin(angle);
  return keptSemiAxes(moments, omega, keep).cwiseProduct(u);
}

Eigen::Vector3d onSeparatrix(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega, ConservedQuantity keep) {
  const SortedAxes axes(moments);
  if (!axes.allDiffer()) throw std::invalid_argument("two moments are equal: there is no separatrix");
  // On the stable half of the arc, where Ω leaves the end of the axis: Ω̇₂ has the sign of (μ₃−μ₁)Ω₃Ω₁, so Ω₂ < 0 there
  // for Ω₁Ω₃ > 0 in a right-handed order of axes; the other way round in a left-handed one.
  const int i1 = axes.index[0], i2 = axes.index[1], i3 = axes.index[2];
  const bool right_handed = (i2 - i1 + 3) % 3 == 1;
  const double s1 = signOf(omega[i1]), s2 = signOf(omega[i2]);
  const double s3 = s1 * (right_handed ? -s2 : s2);
  const SeparatrixPlane plane(axes, 1, s1, s3);
  const Direction direction{s2 * std::cos(kAlongSeparatrix), std::sin(kAlongSeparatrix)};
  Eigen::Vector3d best = *pointTowards(keptSemiAxes(moments, omega, keep), plane(direction));
  // Only Ω₃ is moved, by a few last bits, and E and |L| with it.
  Eigen::Vector3d trial = best;
  for (int i = 0; i < kUlps; ++i) trial[i3] = std::nextafter(trial[i3], -HUGE_VAL);
  for (int i = 0; i < 2 * kUlps; ++i) {
    trial[i3] = std::nextafter(trial[i3], HUGE_VAL);
    if (residual(axes, trial) < residual(axes, best)) best = trial;
  }
  return best;
}

}  // namespace poinsot::view
