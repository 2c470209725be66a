#include <cmath>
#include <cstdio>
#include <ostream>

#include "drawn.h"

namespace poinsot::node {
namespace {

struct Case {
  Vector3d moments, omega;
};
const Case kCases[] = {{{1, 2.49, 1.86}, {0, 0.2, 3}},    // scenes/dzhanibekov.yaml, about
                       {{1, 2, 3}, {0.3, 0.2, 1}},        // about the largest
                       {{1, 2, 3}, {1, 0.2, 0.3}},        // about the smallest
                       {{5, 5, 3}, {0, -0.84, 3}},        // prolate
                       {{1, 1, 1.998}, {0, -0.85, 2}},    // oblate
                       {{3, 4, 6}, {0.014, 3, -0.007}}};  // separatrix

// What follows from Poinsot's construction must hold of the drawing to roundoff; ω from differences, to their error.
constexpr double kDrawn = 1e-12;
constexpr double kDifferenced = 1e-7;

Vector3d normalOf(const Marker& disc) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i + 2 < disc.points.size(); i += 3) {
    sum += (placed(disc, i + 1) - placed(disc, i)).cross(placed(disc, i + 2) - placed(disc, i));
  }
  return sum.normalized();
}

/** How far the drawing is from rolling without slipping at t; all relative or in metres of a picture of about 1 m. */
struct Faults {
  double off_plane, off_ellipsoid, tilt, slip;
  bool none() const { return off_plane < kDrawn && off_ellipsoid < kDrawn && tilt < kDrawn && slip < kDifferenced; }
};

std::ostream& operator<<(std::ostream& out, const Faults& faults) {
  return out << "the tip of omega is " << faults.off_plane << " m off the plane and " << faults.off_ellipsoid
             << " off the ellipsoid; plane and ellipsoid are tilted by " << faults.tilt
             << "; the point of contact slips at " << faults.slip << " of |omega| r";
}

Faults faultsOf(Drawn& drawn, double t) {
  const Marker& disc = drawn.get("space/invariable_plane");
  const Marker& ellipsoid = drawn.get("space/energy_ellipsoid");
  EXPECT_EQ(disc.header.frame_id, "body_space");
  EXPECT_EQ(ellipsoid.header.frame_id, "body_space_body");
  const Vector3d tip = drawn.tip(t), normal = normalOf(disc);
  Faults out{};
  for (std::size_t i = 0; i < disc.points.size(); ++i) {
    out.off_plane = std::max(out.off_plane, std::abs((placed(disc, i) - tip).dot(normal)));
  }
  const Eigen::Matrix3d axes = (drawn.attitude(t) * quaternion(ellipsoid.pose.orientation)).toRotationMatrix();
  const Vector3d semi = 0.5 * vector(ellipsoid.scale);
  const Vector3d local = axes.transpose() * tip;
  out.off_ellipsoid = std::abs(local.cwiseQuotient(semi).squaredNorm() - 1);
  const Vector3d gradient = axes * local.cwiseQuotient(semi.cwiseProduct(semi));
  out.tilt = gradient.cross(normal).norm() / gradient.norm();
  const Vector3d omega = drawn.spin(t, 1e-5);
  out.slip = omega.cross(tip).norm() / (omega.norm() * tip.norm());
  return out;
}

TEST(Rolling, theEnergyEllipsoidTouchesThePlaneAtTheTipOfOmegaAndDoesNotSlip) {
  for (const Case& c : kCases) {
    Drawn drawn(c.moments, c.omega);
    for (const double t : {0.0, 0.7, 3.1, -12.3, 100.0}) {
      const Faults faults = faultsOf(drawn, t);
      EXPECT_TRUE(faults.none()) << faults;
    }
  }
}

TEST(Rolling, soDoesTheOneOfABodyWhoseAxesAreNotThePrincipalOnes) {
  Eigen::Matrix3d tensor;
  tensor << 2, 0.3, -0.2, 0.3, 3, 0.4, -0.2, 0.4, 2.5;
  Drawn drawn(PrincipalInertia::fromTensor(tensor), {0.4, 1, -0.3}, Eigen::Quaterniond(0.1, 0.7, 0.7, 0).normalized());
  for (const double t : {0.0, 1.7}) EXPECT_TRUE(faultsOf(drawn, t).none()) << faultsOf(drawn, t);
}

TEST(Rolling, aDrawingThatIsWrongIsNoticed) {
  const Case& c = kCases[0];
  Drawn near(c.moments, c.omega), tilted(c.moments, c.omega), large(c.moments, c.omega), turned(c.moments, c.omega);
  auto& place = near.get("space/invariable_plane").pose.position;
  place.x *= 0.999, place.y *= 0.999, place.z *= 0.999;
  EXPECT_GT(faultsOf(near, 0.7).off_plane, 1e-5);
  tilted.get("space/invariable_plane").pose.orientation.x += 1e-3;
  EXPECT_GT(faultsOf(tilted, 0.7).tilt, 1e-5);
  large.get("space/energy_ellipsoid").scale.y *= 1.001;
  EXPECT_GT(faultsOf(large, 0.7).off_ellipsoid, 1e-5);
  turned.get("space/energy_ellipsoid").pose.orientation.z += 1e-2;
  EXPECT_GT(faultsOf(turned, 0.7).tilt, 1e-5);
  EXPECT_GT(turned.spin(0.7, 1e-5).cross(turned.tip(0.8)).norm(), 1e-5);  // not the tip of that time
}

double length(const Marker& line) {
  double out = 0;
  for (std::size_t i = 1; i < line.points.size(); ++i) out += (placed(line, i) - placed(line, i - 1)).norm();
  return out;
}

/** How often the herpolhode comes nearest to the plane's centre: once in each half period. */
int halfPeriodsOf(const Marker& line, const Vector3d& normal) {
  std::vector<double> radius;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Vector3d p = placed(line, i);
    radius.push_back((p - p.dot(normal) * normal).norm());
  }
  int count = 0;
  for (std::size_t i = 1; i + 1 < radius.size(); ++i) count += radius[i] < radius[i - 1] && radius[i] <= radius[i + 1];
  return count;
}

TEST(Rolling, theTwoCurvesAreRolledOffEachOther) {
  for (const Case& c : {kCases[0], kCases[1], kCases[2]}) {
    Drawn drawn(c.moments, c.omega);
    const Marker& herpolhode = drawn.get("space/herpolhode");
    const Marker& polhode = drawn.get("space/polhode");
    const int half_periods = halfPeriodsOf(herpolhode, normalOf(drawn.get("space/invariable_plane")));
    ASSERT_GE(half_periods, 1);
    EXPECT_NEAR(length(herpolhode) / (0.5 * half_periods * length(polhode)), 1, 5e-3)
        << "the herpolhode as drawn is not as long as the polhode that it is rolled off";

    // The same of the tip itself, on its way over plane and body.
    double on_plane = 0, on_body = 0;
    Vector3d last = drawn.tip(0), last_body = drawn.attitude(0).conjugate() * last;
    for (int i = 1; i <= 2000; ++i) {
      const double t = 2e-3 * i;
      const Vector3d tip = drawn.tip(t), body = drawn.attitude(t).conjugate() * tip;
      on_plane += (tip - last).norm();
      on_body += (body - last_body).norm();
      last = tip;
      last_body = body;
    }
    EXPECT_NEAR(on_plane / on_body, 1, 1e-5) << "the tip of omega goes further over one than over the other";
    EXPECT_GT(on_plane, 0.1);
  }
}

TEST(Rolling, theHerpolhodeIsOnThePlaneWhereTheTipComesBy) {
  for (const Case& c : kCases) {
    Drawn drawn(c.moments, c.omega);
    const Marker& line = drawn.get("space/herpolhode");
    EXPECT_LE(line.points.size(), 1025u);
    EXPECT_EQ(line.type, Marker::LINE_STRIP);
    const Vector3d normal = normalOf(drawn.get("space/invariable_plane"));
    const double height = drawn.tip(0).dot(normal);
    const double lift = placed(line, 0).dot(normal) / height;
    EXPECT_GT(lift, 1);
    EXPECT_LT(lift, 1.02);
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      EXPECT_NEAR(placed(line, i).dot(normal) / height, lift, 1e-12) << "point " << i << " is off the plane";
    }
  }
  Drawn steady({1, 2, 3}, {0, 2, 0});
  EXPECT_EQ(steady.get("space/herpolhode").type, Marker::SPHERE_LIST);
  EXPECT_EQ(steady.get("space/herpolhode").points.size(), 1u);
  EXPECT_FALSE(steady.has("space/montgomery"));
  Drawn at_rest({1, 2, 3}, {0, 0, 0});
  EXPECT_FALSE(at_rest.has("space/invariable_plane"));
  EXPECT_FALSE(at_rest.has("space/herpolhode"));
}

/** The angle of the drawn sector [rad], from its first spoke to its last, about L. */
double angleDrawn(const Marker& sector, const Vector3d& normal) {
  const Vector3d foot = placed(sector, 0);
  double sum = 0;
  for (std::size_t i = 1; i + 2 < sector.points.size(); ++i) {
    const Vector3d a = placed(sector, i) - foot, b = placed(sector, i + 1) - foot;
    sum += std::atan2(a.cross(b).dot(normal), a.dot(b));
  }
  return sum;
}

/** The solid angle [sr] of the cone over the directions of M·p, p the drawn polhode, on the side of its axis; ≥ 0. */
double solidAngle(const Marker& polhode, const Vector3d& moments) {
  std::vector<Vector3d> directions;
  Vector3d axis = Vector3d::Zero();
  for (std::size_t i = 0; i < polhode.points.size(); ++i) {
    directions.push_back(moments.cwiseProduct(placed(polhode, i)).normalized());
    if (i > 0) axis += directions[i - 1].cross(directions[i]);
  }
  axis.normalize();
  if (axis.dot(directions[0]) < 0) axis = -axis;
  double sum = 0;
  for (std::size_t i = 1; i < directions.size(); ++i) {  // Van Oosterom & Strackee 1983
    const Vector3d &a = axis, &b = directions[i - 1], &c = directions[i];
    sum += 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return std::abs(sum);
}

/** When the bead is back where it began [s], near `guess`. */
double periodOf(Drawn& drawn, double guess) {
  const Vector3d start = drawn.bead(0), ahead = (drawn.bead(1e-4) - drawn.bead(-1e-4)).normalized();
  double low = 0.97 * guess, high = 1.03 * guess;
  const auto before = [&](double t) { return (drawn.bead(t) - start).dot(ahead) < 0; };
  EXPECT_TRUE(before(low));
  EXPECT_FALSE(before(high));
  for (int i = 0; i < 60; ++i) (before((low + high) / 2) ? low : high) = (low + high) / 2;
  return low;
}

/** Legendre's normal form: 4K/rate, for moments in rising order. */
double periodByElliptic(const Vector3d& m, const Vector3d& omega) {
  const double e2 = omega.dot(m.cwiseProduct(omega)), f = m.cwiseProduct(omega).squaredNorm();
  const int a = f > e2 * m[1] ? 2 : 0, c = 2 - a;
  const double rate2 = (m[a] - m[1]) * (f - e2 * m[c]) / (m[0] * m[1] * m[2]);
  const double k2 = (m[1] - m[c]) * (e2 * m[a] - f) / ((m[a] - m[1]) * (f - e2 * m[c]));
  return 4 * std::comp_ellint_1(std::sqrt(k2)) / std::sqrt(rate2);
}

TEST(Montgomery, theSectorIsTwiceEnergyTimesPeriodLessTheSolidAngleOfThePolhode) {
  for (const Case& c : {Case{{1, 1.86, 2.49}, {0, 3, 0.2}}, kCases[1], kCases[2], Case{{1, 1.5, 3}, {0.2, 1, 0.4}},
                        Case{{1, 1.1, 1.9}, {1, 0.4, 0.6}}}) {
    Drawn drawn(c.moments, c.omega);
    const double period = periodOf(drawn, periodByElliptic(c.moments, c.omega));
    EXPECT_NEAR(period / periodByElliptic(c.moments, c.omega), 1, 1e-6);
    const double e2 = c.omega.dot(c.moments.cwiseProduct(c.omega)), l = c.moments.cwiseProduct(c.omega).norm();
    // Seen from outside, does Λ go round counterclockwise? Then the solid angle counts as positive.
    const Vector3d p = c.moments.cwiseProduct(drawn.bead(0.3)), q = c.moments.cwiseProduct(drawn.bead(0.301));
    Eigen::Index axis = e2 * c.moments[1] < l * l ? 2 : 0;
    const double sense = p.cross(q)[axis] * p[axis] > 0 ? 1 : -1;
    const double wanted = e2 * period / l - sense * solidAngle(drawn.get("model/polhode"), c.moments);
    const Vector3d normal = normalOf(drawn.get("space/invariable_plane"));
    const double angle = angleDrawn(drawn.get("space/montgomery"), normal);
    EXPECT_GE(angle, 0);
    EXPECT_LT(angle, 2 * M_PI);
    EXPECT_NEAR(std::remainder(angle - wanted, 2 * M_PI), 0, 2e-3);
    // A wrong sign would not pass, nor an angle about the other way.
    EXPECT_GT(std::abs(std::remainder(angle - wanted - 2 * sense * solidAngle(drawn.get("model/polhode"), c.moments),
                                      2 * M_PI)),
              0.05);

    // From spoke to spoke in the world: where ω is at its outermost, and one period later.
    const Marker& sector = drawn.get("space/montgomery");
    const Vector3d first = placed(sector, 1) - placed(sector, 0);
    const Vector3d last = placed(sector, sector.points.size() - 2) - placed(sector, 0);
    double outermost = 0, when = 0;
    for (int i = 0; i < 4000; ++i) {
      const double t = period * i / 4000;
      const Vector3d tip = drawn.tip(t);
      const double radius = (tip - tip.dot(normal) * normal).norm();
      const Vector3d away = tip - tip.dot(normal) * normal;
      if (angleBetween(away, first) < 0.05 && radius > outermost) {
        outermost = radius;
        when = t;
      }
    }
    ASSERT_GT(outermost, 0);
    const Vector3d later = drawn.tip(when + period), at_first = drawn.tip(when);
    EXPECT_LT(angleBetween(at_first - at_first.dot(normal) * normal, first), 0.05);
    EXPECT_LT(angleBetween(later - later.dot(normal) * normal, last), 0.05);

    // The words: whole turns and the rest.
    int turns = 0;
    double degrees = -1;
    const std::string text = drawn.words("one round");
    const std::string second = text.substr(text.find('\n') + 1);
    if (std::sscanf(second.c_str(), "%d \xC3\x97 360\xC2\xB0 + %lf", &turns, &degrees) != 2) {
      turns = 0;
      ASSERT_EQ(std::sscanf(second.c_str(), "%lf", &degrees), 1) << text;
    }
    EXPECT_NEAR(degrees, angle * 180 / M_PI, 0.051);
    // The whole turns: ω·L/|L| is 2E/|L| at all times, and what the polhode adds to its integral is less than a turn.
    EXPECT_LT(std::abs(turns * 2 * M_PI + angle - e2 * period / l), 2 * M_PI + 1e-3);
  }
}

}  // namespace
}  // namespace poinsot::node
