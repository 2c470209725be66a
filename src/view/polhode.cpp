#include "poinsot/view/polhode.h"

#include <algorithm>
#include <cmath>

#include "even_spread.h"
#include "separatrix_plane.h"
#include "sorted_axes.h"

namespace poinsot::view {
namespace {

Curve mirrored(const Curve& curve) {
  Curve out{{}, curve.closed};
  out.points.reserve(curve.points.size());
  for (const Eigen::Vector3d& p : curve.points) out.points.push_back(-p);
  return out;
}

/** Returns half of a closed curve, from c = 1 over s = 1 to c = −1, both ends included. */
template <class Point>
Curve openArc(int points, const Point& point) {
  const std::vector<Direction> quarter = evenQuarter(2 * segmentsPerQuarter(points), point);
  Curve out{{}, false};
  for (const Direction& d : quarter) out.points.push_back(point(d));
  for (auto d = quarter.rbegin() + 1; d != quarter.rend(); ++d) out.points.push_back(point({-d->c, d->s}));
  return out;
}

/**
 * The loop about axis a. With b the intermediate and c the third axis, dᵢⱼ = |Iᵢ−Iⱼ|, and, from the components of Ω,
 *   P = I_c d_ac Ω_c² + I_b d_ab Ω_b²,   Q = μ_a d_ac Ω_a² + I_b d_bc Ω_b²,   D = μ_a d_ab Ω_a² − I_c d_bc Ω_c² > 0
 * (that is |2Eμ_a − F|, |F − 2EI_c|, |F − 2EI_b|), eliminating one component after the other gives
 *   Ω_c = √(P/(I_c d_ac)) cos φ,   Ω_b = √(P/(I_b d_ab)) sin φ,
 *   Ω_a² = (Q cos²φ + (d_ac/d_ab) D sin²φ)/(μ_a d_ac).
 * Only D is a difference; its roundoff is that of Ω_a² and no more.
 */
class Loop {
 public:
  /** @param a 0 or 2, place of the axis in `axes`; omega in the same (sorted) order, |Ω| about 1. */
  Loop(const SortedAxes& axes, const Eigen::Vector3d& omega, int a) : ia_(axes.index[a]), ib_(axes.index[1]) {
    const int c = 2 - a;
    ic_ = axes.index[c];
    const auto& m = axes.moment;
    const auto root = [](double moment, double difference) { return std::sqrt(moment) * std::sqrt(difference); };
    const double ab = std::abs(m[a] - m[1]), bc = std::abs(m[1] - m[c]), ac = m[2] - m[0];

    // Roots throughout: the squares of small components would underflow.
    const double p = std::hypot(root(m[c], ac) * omega[c], root(m[1], ab) * omega[1]);
    const double q = std::hypot(root(m[a], ac) * omega[a], root(m[1], bc) * omega[1]);
    const double x = root(m[a], ab) * std::abs(omega[a]), y = root(m[c], bc) * std::abs(omega[c]);
    const double d = std::sqrt(std::max(0.0, x - y)) * std::sqrt(x + y);

    size_c_ = p / root(m[c], ac);
    size_b_ = p / root(m[1], ab);
    size_a_ = std::copysign(1.0, omega[a]) * q / root(m[a], ac);
    waist_a_ = d / root(m[a], ab);
  }

  /** Returns the point at φ, (c, s) = (cos φ, sin φ), in the caller's order of axes. */
  Eigen::Vector3d operator()(const Direction& d) const {
    Eigen::Vector3d out;
    out[ia_] = std::copysign(std::hypot(size_a_ * d.c, waist_a_ * d.s), size_a_);
    out[ib_] = size_b_ * d.s;
    out[ic_] = size_c_ * d.c;
    return out;
  }

 private:
  int ia_, ib_, ic_ = 0;
  double size_a_, size_b_, size_c_, waist_a_;
};

/** Returns the sign of F − 2Eμ₂. @param omega sorted components of Ω. */
int sideOfSeparatrix(const SortedAxes& axes, const Eigen::Vector3d& omega) {
  // Scaled exactly by the larger of the two components, whose squares might otherwise both underflow.
  const int exponent = std::ilogb(std::max(std::abs(omega[0]), std::abs(omega[2])));
  const long double o0 = std::ldexp(omega[0], -exponent), o2 = std::ldexp(omega[2], -exponent);
  const long double i0 = axes.moment[0], i1 = axes.moment[1], i2 = axes.moment[2];
  const long double d = i2 * (i2 - i1) * o2 * o2 - i0 * (i1 - i0) * o0 * o0;
  return (d > 0) - (d < 0);
}

Polhode steady(const Eigen::Vector3d& omega) {
  return {Regime::axis_spin, {Curve{{omega}, false}, Curve{{-omega}, false}}};
}

/** Returns the polhode for two equal moments. @param a the place of the third among the sorted axes. */
Polhode symmetric(const SortedAxes& axes, const Eigen::Vector3d& sorted, const Eigen::Vector3d& omega, int a,
                  int points) {
  const int c = 2 - a;
  const double radius = std::hypot(sorted[1], sorted[c]);
  if (radius == 0 || sorted[a] == 0) return steady(omega);
  const auto point = [&](const Direction& d) {
    Eigen::Vector3d out;
    out[axes.index[a]] = sorted[a];
    out[axes.index[1]] = radius * d.s;
    out[axes.index[c]] = radius * d.c;
    return out;
  };
  const Curve circle = closedCurve(points, point);
  return {Regime::circle, {circle, mirrored(circle)}};
}

Polhode onSeparatrix(const SortedAxes& axes, const Eigen::Vector3d& sorted, int points) {
  double root = 0;  // √(2E)
  for (int i = 0; i < 3; ++i) root = std::hypot(root, std::sqrt(axes.moment[i]) * sorted[i]);
  const double sign1 = std::copysign(1.0, sorted[0]), sign3 = std::copysign(1.0, sorted[2]);
  const Curve own = openArc(points, SeparatrixPlane(axes, root, sign1, sign3));
  const Curve other = openArc(points, SeparatrixPlane(axes, root, sign1, -sign3));
  return {Regime::separatrix, {own, mirrored(own), other, mirrored(other)}};
}

/** Returns the polhode for |Ω| about 1. */
Polhode scaledPolhode(const SortedAxes& axes, const Eigen::Vector3d& omega, int points) {
  const auto& m = axes.moment;
  if (m[0] == m[2]) return {Regime::sphere, {}};
  const Eigen::Vector3d sorted = axes.sorted(omega);
  if (m[0] == m[1]) return symmetric(axes, sorted, omega, 2, points);
  if (m[1] == m[2]) return symmetric(axes, sorted, omega, 0, points);
  if ((sorted.array() == 0).count() == 2) return steady(omega);

  const int side = sideOfSeparatrix(axes, sorted);
  if (side == 0) return onSeparatrix(axes, sorted, points);
  const Curve loop = closedCurve(points, Loop(axes, sorted, side > 0 ? 2 : 0));
  return {side > 0 ? Regime::about_largest : Regime::about_smallest, {loop, mirrored(loop)}};
}

}  // namespace

Polhode polhode(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal, int points_per_branch) {
  const double largest = omega_principal.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return {};
  const int exponent = std::ilogb(largest);
  const auto scaled = [](const Eigen::Vector3d& v, int e) {
    return Eigen::Vector3d(std::ldexp(v[0], e), std::ldexp(v[1], e), std::ldexp(v[2], e));
  };
  Polhode out = scaledPolhode(SortedAxes(moments), scaled(omega_principal, -exponent), points_per_branch);
  for (Curve& branch : out.branches) {
    for (Eigen::Vector3d& p : branch.points) p = scaled(p, exponent);
  }
  return out;
}

}  // namespace poinsot::view
