#include <algorithm>
#include <cmath>

#include "drawn.h"

namespace poinsot::node {
namespace {

/** A list of lines as the closed polygons that it consists of. */
std::vector<std::vector<Vector3d>> polygonsOf(const Marker& lines) {
  std::vector<std::vector<Vector3d>> out;
  for (std::size_t i = 0; i + 1 < lines.points.size(); i += 2) {
    const Vector3d a = placed(lines, i), b = placed(lines, i + 1);
    const bool closed =
        !out.empty() && out.back().size() > 2 && (out.back().front() - out.back().back()).norm() < 1e-12;
    if (out.empty() || closed || (out.back().back() - a).norm() > 1e-12) out.push_back({a});
    out.back().push_back(b);
  }
  for (const auto& polygon : out) EXPECT_LT((polygon.front() - polygon.back()).norm(), 1e-12);
  return out;
}

struct Faults {
  double off_ellipsoid = 0;      ///< once the common lift is undone
  double energy_spread = 0;      ///< within a member, relative
  std::vector<double> energies;  ///< of the members, ½ΩᵀMΩ with Ω in metres
  double lift = 0;
};

Faults faultsOf(Drawn& drawn, int id, const Vector3d& moments) {
  Faults out;
  const Marker& ellipsoid = drawn.get("model/momentum_ellipsoid");
  const Marker& lines = drawn.get("model/polhode_family", id);
  EXPECT_EQ(lines.header.frame_id, ellipsoid.header.frame_id);
  const Eigen::Matrix3d to_axes = quaternion(ellipsoid.pose.orientation).toRotationMatrix().transpose();
  const Vector3d semi = 0.5 * vector(ellipsoid.scale);
  const auto level = [&](const Vector3d& p) { return (to_axes * p).cwiseQuotient(semi).norm(); };
  const auto polygons = polygonsOf(lines);
  out.lift = level(polygons[0][0]);
  for (const auto& polygon : polygons) {
    const auto energy = [&](const Vector3d& p) {
      const Vector3d omega = to_axes * p / out.lift;
      return 0.5 * omega.dot(moments.cwiseProduct(omega));
    };
    const double first = energy(polygon[0]);
    out.energies.push_back(first);
    for (const Vector3d& p : polygon) {
      out.off_ellipsoid = std::max(out.off_ellipsoid, std::abs(level(p) / out.lift - 1));
      out.energy_spread = std::max(out.energy_spread, std::abs(energy(p) / first - 1));
    }
  }
  return out;
}

// The principal axes are those of the scene in all of these: moments in the order of the ellipsoid's axes.
const std::pair<Vector3d, Vector3d> kBodies[] = {
    {{1, 2.49, 1.86}, {0, 0.2, 3}}, {{1, 2, 3}, {1, 0.2, 0.3}}, {{5, 5, 3}, {0, -0.84, 3}}, {{1, 2, 3}, {0, 1, 0}}};

TEST(Family, liesOnTheMomentumEllipsoidEachMemberWithOneEnergy) {
  for (const auto& [moments, omega] : kBodies) {
    Drawn drawn(moments, omega);
    const Faults f = faultsOf(drawn, 0, moments);
    EXPECT_LT(f.off_ellipsoid, 1e-12);
    EXPECT_LT(f.energy_spread, 1e-12);
    EXPECT_GT(f.lift, 1);
    EXPECT_LT(f.lift, 1.01);
    // Between the least and the greatest that this |L| allows, and two lines, mirror images, for each.
    const Vector3d semi = 0.5 * vector(drawn.get("model/momentum_ellipsoid").scale);
    const double f2 = std::pow(semi[0] * moments[0], 2);
    std::vector<double> energies = f.energies;
    std::sort(energies.begin(), energies.end());
    EXPECT_GT(energies.front(), 0.5 * f2 / moments.maxCoeff());
    EXPECT_LT(energies.back(), 0.5 * f2 / moments.minCoeff());
    ASSERT_EQ(energies.size() % 2, 0u);
    for (std::size_t i = 0; i + 1 < energies.size(); i += 2) {
      EXPECT_NEAR(energies[i] / energies[i + 1], 1, 1e-12);
      if (i > 0) {
        EXPECT_GT(energies[i] / energies[i - 1], 1 + 1e-3);
      }
    }
  }
}

TEST(Family, hasTheSeparatricesOfThatMomentum) {
  for (const auto& [moments, omega] : kBodies) {
    Drawn drawn(moments, omega);
    if (moments[0] == moments[1]) {
      EXPECT_THROW(drawn.get("model/polhode_family", 1), std::runtime_error);
      continue;
    }
    const Faults f = faultsOf(drawn, 1, moments);
    EXPECT_LT(f.off_ellipsoid, 1e-12);
    EXPECT_LT(f.energy_spread, 1e-12);
    ASSERT_EQ(f.energies.size(), 2u);
    Vector3d sorted = moments;
    std::sort(sorted.data(), sorted.data() + 3);
    const Vector3d semi = 0.5 * vector(drawn.get("model/momentum_ellipsoid").scale);
    for (const double e : f.energies) EXPECT_NEAR(2 * e * sorted[1] / std::pow(semi[0] * moments[0], 2), 1, 1e-12);
    EXPECT_EQ(drawn.get("model/polhode_family", 1).color, drawn.get("model/separatrix").color);
  }
}

TEST(Family, thatIsWrongIsNoticed) {
  const auto& [moments, omega] = kBodies[1];
  Drawn off(moments, omega), slanted(moments, omega);
  off.get("model/polhode_family").points[6].x *= 1.001;
  off.get("model/polhode_family").points[5].x *= 1.001;
  EXPECT_GT(faultsOf(off, 0, moments).off_ellipsoid, 1e-6);
  slanted.get("model/polhode_family").pose.orientation.z += 1e-3;
  EXPECT_GT(faultsOf(slanted, 0, moments).energy_spread, 1e-6);
}

TEST(Family, costsFewBytes) {
  for (const auto& [moments, omega] : kBodies) {
    Drawn drawn(moments, omega);
    std::size_t points = 0;
    for (const Marker& m : drawn.still.markers) {
      if (m.ns == "body/model/polhode_family") points += m.points.size();
    }
    EXPECT_LT(24 * points, 60000u);
  }
}

}  // namespace
}  // namespace poinsot::node
