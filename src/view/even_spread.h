#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "poinsot/core/pi.h"
#include "poinsot/view/curve.h"

namespace poinsot::view {

/** Cosine and sine of an angle in the first quarter, exact at its ends. */
struct Direction {
  double c, s;
};

/** Returns the direction at an angle that is `end_fraction` of a quarter turn. */
inline Direction quarterDirection(double angle, double end_fraction) {
  if (end_fraction <= 0) return {1, 0};
  if (end_fraction >= 1) return {0, 1};
  return {std::cos(angle), std::sin(angle)};
}

/** Returns how many segments a quarter of a curve has for `points` on all of it, rounded up to a multiple of 4, ≥ 8. */
inline int segmentsPerQuarter(int points) {
  return std::max(2, (points + 3) / 4);
}

/** Returns how many points of a circle keep lines between them within the tolerance of it, r(1 − cos π/n). */
inline double pointsOfCircle(double radius, double tolerance) {
  return std::ceil(3.15 * std::sqrt(radius / (2 * tolerance)));
}

/**
 * Returns `segments` + 1 directions from 0 to π/2 at which the points point(c, s) of a curve are nearly evenly spread
 * in arc length, but denser where the curve turns, so that narrow corners are round too.
 *
 * Length and turning are those of a finer polyline: they decide where on the curve the points lie, not whether they do.
 */
template <class Point>
std::vector<Direction> evenQuarter(int segments, const Point& point) {
  constexpr double kQuarter = kPi / 2;
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

/** Returns a whole turn from a quarter, by reflection: counterclockwise from s = 0, c > 0, which is not repeated. */
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

/** Returns the closed curve of point(c, s) over a whole turn, whose quarters are alike. */
template <class Point>
Curve closedCurve(int points, const Point& point) {
  Curve out{{}, true};
  for (const Direction& d : wholeTurn(evenQuarter(segmentsPerQuarter(points), point))) out.points.push_back(point(d));
  return out;
}

}  // namespace poinsot::view
