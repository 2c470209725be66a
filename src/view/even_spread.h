#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace poinsot::view {

/** Cosine and sine of an angle in the first quarter, exact at its ends. */
struct Direction {
  double c, s;
};

inline Direction quarterDirection(double angle, double end_fraction) {
  if (end_fraction <= 0) return {1, 0};
  if (end_fraction >= 1) return {0, 1};
  return {std::cos(angle), std::sin(angle)};
}

/** Points a quarter of a curve gets out of `points` on the whole of it: a multiple of four, at least eight, rounded up.
 */
inline int segmentsPerQuarter(int points) {
  return std::max(2, (points + 3) / 4);
}

/** Of a circle that straight lines between them are to stray from by no more than the tolerance, r(1 − cos π/n). */
inline double pointsOfCircle(double radius, double tolerance) {
  return std::ceil(3.15 * std::sqrt(radius / (2 * tolerance)));
}

/**
 * Directions 0 … π/2, `segments` + 1 of them, at which the curve point(c, s) is passed in steps of nearly equal arc
 * length; a share of them goes where the curve turns, so that narrow corners are round too.
 *
 * Length and turning are those of a finer polyline. The points themselves are the caller's: this affects where on the
 * curve they lie, not whether they do.
 */
template <class Point>
std::vector<Direction> evenQuarter(int segments, const Point& point) {
  constexpr double kQuarter = 1.57079632679489661923;
  constexpr int kFiner = 16;
  constexpr double kForTurning = 0.3;
  const int n = segments * kFiner;
  const auto direction = [&](double i) { return quarterDirection(kQuarter * i / n, i / n); };

  std::vector<double> length(n + 1, 0.0), turning(n + 1, 0.0);
  Eigen::Vector3d last = point(direction(0)), last_heading = Eigen::Vector3d::Zero();
  for (int i = 1; i <= n; ++i) {
    const Eigen::Vector3d next = point(direction(i));
    const Eigen::Vector3d heading = (next - last).stableNormalized();
    length[i] = length[i - 1] + (next - last).stableNorm();
    turning[i] = turning[i - 1] + std::atan2(heading.cross(last_heading).norm(), heading.dot(last_heading));
    last = next;
    last_heading = heading;
  }
  const auto share = [n](const std::vector<double>& sum, int i) { return sum[n] > 0 ? sum[i] / sum[n] : 0.0; };
  std::vector<double> progress(n + 1);
  for (int i = 0; i <= n; ++i) progress[i] = (1 - kForTurning) * share(length, i) + kForTurning * share(turning, i);

  std::vector<Direction> out(segments + 1);
  int i = 0;
  for (int k = 0; k <= segments; ++k) {
    const double wanted = progress[n] * k / segments;
    while (i < n - 1 && progress[i + 1] < wanted) ++i;
    const double piece = progress[i + 1] - progress[i];
    const double inside = piece > 0 ? std::min(1.0, std::max(0.0, (wanted - progress[i]) / piece)) : 0.0;
    out[k] = direction(k == 0 ? 0.0 : k == segments ? n : i + inside);
  }
  return out;
}

/** A whole turn from a quarter, by reflection: c > 0 and s = 0 first, then counterclockwise; does not repeat the first.
 */
inline std::vector<Direction> wholeTurn(const std::vector<Direction>& quarter) {
  const int n = static_cast<int>(quarter.size()) - 1;
  std::vector<Direction> out;
  out.reserve(4 * n);
  for (int k = 0; k < n; ++k) out.push_back({quarter[k].c, quarter[k].s});
  for (int k = n; k > 0; --k) out.push_back({-quarter[k].c, quarter[k].s});
  for (int k = 0; k < n; ++k) out.push_back({-quarter[k].c, -quarter[k].s});
  for (int k = n; k > 0; --k) out.push_back({quarter[k].c, -quarter[k].s});
  return out;
}

}  // namespace poinsot::view
