#include <cmath>

#include "drawn.h"

namespace poinsot::node {
namespace {

constexpr double kDrawn = 1e-12;
constexpr double kDifferenced = 1e-7;

/** As drawn, in its frame. */
struct Cone {
  Vector3d axis;
  double angle = 0, uneven = 0;  ///< half the opening [rad]; how far corners are from it
};

Cone coneOf(Drawn& drawn, const char* what, const char* frame) {
  Cone out;
  for (const int id : {0, 1}) {
    const Marker& m = drawn.get(what, id);
    EXPECT_EQ(m.header.frame_id, frame);
    std::vector<Vector3d> rim;
    for (std::size_t i = 0; i < m.points.size(); ++i) {
      const Vector3d p = placed(m, i);
      if (p.norm() == 0) continue;  // the apex
      rim.push_back(p);
    }
    if (id == 0) {
      const Vector3d a = rim[0], b = rim[rim.size() / 3], c = rim[2 * rim.size() / 3];
      out.axis = (b - a).cross(c - a).normalized();
      if (out.axis.dot(a) < 0) out.axis = -out.axis;
      out.angle = angleBetween(out.axis, a);
    }
    for (const Vector3d& p : rim) out.uneven = std::max(out.uneven, std::abs(angleBetween(out.axis, p) - out.angle));
  }
  return out;
}

struct Faults {
  double body_angle, space_angle;  ///< against the textbook's [rad]
  double off_body, off_space;      ///< ω beside either mantle [rad]
  double apart;                    ///< the angle between the axes against β ± σ: they cut, or do not touch [rad]
  double slip;                     ///< of the body's points on the line of contact, relative to |ω|
  bool none() const {
    return body_angle < kDrawn && space_angle < kDrawn && off_body < kDrawn && off_space < kDrawn && apart < kDrawn &&
           slip < kDifferenced;
  }
};

/** A: the two equal moments, about x and y; C the third. */
Faults faultsOf(Drawn& drawn, double a, double c, const Vector3d& omega_body, double t) {
  const Cone body = coneOf(drawn, "space/body_cone", "body_space_body");
  const Cone space = coneOf(drawn, "space/space_cone", "body_space");
  const double beta = std::atan(std::hypot(omega_body.x(), omega_body.y()) / std::abs(omega_body.z()));
  const double theta = std::atan(a / c * std::tan(beta));
  const Vector3d omega = drawn.tip(t), axis = drawn.attitude(t) * body.axis;
  Faults out{};
  out.body_angle = std::abs(body.angle - beta) + body.uneven;
  out.space_angle = std::abs(space.angle - std::abs(theta - beta)) + space.uneven;
  out.off_body = std::abs(angleBetween(axis, omega) - body.angle);
  out.off_space = std::abs(angleBetween(space.axis, omega) - space.angle);
  // Flat bodies: the body cone goes round the space cone.
  const double between = c < a ? body.angle + space.angle : body.angle - space.angle;
  out.apart = std::abs(angleBetween(axis, space.axis) - between);
  const Vector3d spin = drawn.spin(t, 1e-5);
  out.slip = spin.cross(omega.normalized()).norm() / spin.norm();
  return out;
}

struct Case {
  double a, c;
  Vector3d omega;
};
const Case kCases[] = {{5, 3, {0, -0.84, 3}}, {1, 1.998, {0, -0.85, 2}}, {2, 0.3, {1, 1, -1}}, {2, 3.9, {0.5, 2, 1}}};

TEST(Cones, rollOnEachOtherAlongOmega) {
  for (const Case& c : kCases) {
    Drawn drawn({c.a, c.a, c.c}, c.omega);
    for (const double t : {0.0, 0.4, 5.0, -77.7}) {
      const Faults f = faultsOf(drawn, c.a, c.c, c.omega, t);
      EXPECT_TRUE(f.none()) << f.body_angle << " " << f.space_angle << " " << f.off_body << " " << f.off_space << " "
                            << f.apart << " " << f.slip;
    }
  }
}

TEST(Cones, ofABodyWhoseAxesAreNotThePrincipalOnes) {
  // Moments 5, 5, 3, the third along (1, 1, 0)/√2: a tensor in whole numbers, whose moments may come out equal only
  // to roundoff. Then the body has no axis of symmetry, and no cones.
  Eigen::Matrix3d tensor;
  tensor << 4, -1, 0, -1, 4, 0, 0, 0, 5;
  const PrincipalInertia inertia = PrincipalInertia::fromTensor(tensor);
  const bool equal = inertia.moments()[1] == inertia.moments()[2];
  Drawn drawn(inertia, {1, 1.2, 0.3}, Eigen::Quaterniond(0.1, 0.7, 0.7, 0).normalized());
  EXPECT_EQ(drawn.has("space/body_cone"), equal);
  if (!equal) GTEST_SKIP() << "moments differ by roundoff here";
  // In axes with the third along the body's.
  const Vector3d axis = Vector3d(1, 1, 0).normalized(), omega(1, 1.2, 0.3);
  const double along = omega.dot(axis);
  EXPECT_TRUE(faultsOf(drawn, 5, 3, {(omega - along * axis).norm(), 0, along}, 0.4).none());
}

TEST(Cones, thatAreWrongAreNoticed) {
  const Case& c = kCases[0];
  const auto spoilt = [&](const char* what, const auto& spoil) {
    Drawn drawn({c.a, c.a, c.c}, c.omega);
    for (const int id : {0, 1}) spoil(drawn.get(what, id));
    return faultsOf(drawn, c.a, c.c, c.omega, 0.4);
  };
  const auto wider = [](Marker& m) {
    for (auto& p : m.points) p.x *= 1.01, p.y *= 1.01;
  };
  const auto tilted = [](Marker& m) { m.pose.orientation.x += 1e-2; };
  EXPECT_GT(spoilt("space/body_cone", wider).body_angle, 1e-4);
  EXPECT_GT(spoilt("space/body_cone", wider).off_body, 1e-4);
  EXPECT_GT(spoilt("space/body_cone", tilted).off_body, 1e-4);
  EXPECT_GT(spoilt("space/space_cone", tilted).apart, 1e-6);
  EXPECT_GT(spoilt("space/space_cone", wider).space_angle, 1e-4);
}

TEST(Cones, areOfBodiesWithTwoEqualMomentsOnly) {
  EXPECT_FALSE(Drawn({1, 2, 3}, {1, 1, 1}).has("space/body_cone"));
  EXPECT_FALSE(Drawn({2, 2, 2}, {1, 1, 1}).has("space/space_cone"));
  EXPECT_FALSE(Drawn({2, 2, 1}, {0, 0, 1}).has("space/space_cone"));
}

}  // namespace
}  // namespace poinsot::node
