#include "poinsot/core/assembly.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using poinsot::Assembly;
using poinsot::Solid;
using poinsot::SolidType;
namespace shapes = poinsot::shapes;

namespace {

Vector3d centreOfMass(const Assembly& assembly) {
  Vector3d sum = Vector3d::Zero();
  for (const Solid& part : assembly.parts()) sum += part.mass * part.centre;
  return sum / assembly.mass();
}

void expectTensor(const Assembly& assembly, const Matrix3d& expected) {
  const Matrix3d tensor = assembly.inertiaTensor();
  EXPECT_LT((tensor - expected).norm(), 1e-13 * expected.norm()) << tensor << "\n\n" << expected;
}

void expectMoments(const Assembly& assembly, double x, double y, double z) {
  expectTensor(assembly, Vector3d(x, y, z).asDiagonal());
}

/** A solid as a question: is the point in it? In the axes in which the shape is described. */
using Inside = std::function<bool(const Vector3d&)>;

/** Each solid of the same density; where two overlap it counts twice, as an assembly of parts does. */
Matrix3d tensorByMonteCarlo(const std::vector<Inside>& solids, double half_width, double mass) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-half_width, half_width);
  double count = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (int i = 0; i < 4000000; ++i) {
    const Vector3d p(uniform(random), uniform(random), uniform(random));
    for (const Inside& inside : solids) {
      if (!inside(p)) continue;
      ++count;
      first += p;
      second += p * p.transpose();
    }
  }
  const Matrix3d covariance = second / count - (first / count) * (first / count).transpose();
  return mass * (covariance.trace() * Matrix3d::Identity() - covariance);
}

void expectTensorWithin(double tolerance, const Assembly& assembly, const Matrix3d& expected) {
  const Matrix3d tensor = assembly.inertiaTensor();
  EXPECT_LT((tensor - expected).cwiseAbs().maxCoeff(), tolerance * expected.diagonal().maxCoeff()) << tensor << "\n\n"
                                                                                                   << expected;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(tensor(i, i), expected(i, i), 3 * tolerance * expected(i, i));
}

Solid brick(const Vector3d& size, double mass, const Vector3d& centre = Vector3d::Zero(),
            const Quaterniond& orientation = Quaterniond::Identity()) {
  Solid solid;
  solid.size = size;
  solid.mass = mass;
  solid.centre = centre;
  solid.orientation = orientation;
  return solid;
}

std::vector<Assembly> oneOfEach() {
  return {shapes::box({1, 2, 3}, 4),
          shapes::ellipsoid({1, 2, 3}, 4),
          shapes::cylinder(1, 2, 4),
          shapes::tHandle(0.1, 1, 0.05, 0.7, 4),
          shapes::wingnut(0.22, 0.5, {0.75, 0.12, 0.45}, 0.5, 4),
          shapes::lShape(2, 3, 0.5, 4),
          shapes::twoCylinders(0.5, 2, 0.25, 1, {0.5, 0.3, 0.7}, 4)};
}

}  // namespace

TEST(Solid, VolumesAndMomentsOfTheTextbook) {
  Solid solid = brick({1, 2, 3}, 12);
  EXPECT_DOUBLE_EQ(solid.volume(), 6);
  expectMoments(shapes::box({1, 2, 3}, 12), 13, 10, 5);

  solid.type = SolidType::ellipsoid;
  EXPECT_DOUBLE_EQ(solid.volume(), 4 * M_PI / 3 * 0.5 * 1 * 1.5);
  expectMoments(shapes::ellipsoid({2, 4, 6}, 5), 13, 10, 5);
  expectMoments(shapes::ellipsoid({2, 2, 2}, 5), 2, 2, 2);  // a ball, 2/5 m r²

  solid.type = SolidType::cylinder;
  solid.size = {4, 4, 3};
  EXPECT_DOUBLE_EQ(solid.volume(), M_PI * 4 * 3);
  expectMoments(shapes::cylinder(2, 3, 12), 21, 21, 24);
}

TEST(Assembly, TheOriginIsTheCentreOfMass) {
  for (const Assembly& assembly : oneOfEach()) {
    EXPECT_LT(centreOfMass(assembly).norm(), 1e-15);
    EXPECT_NEAR(assembly.mass(), 4, 1e-14);
  }
  const Assembly pair({brick({1, 1, 1}, 1, {10, 0, 0}), brick({1, 1, 1}, 3, {14, 0, 0})});
  EXPECT_LT((pair.parts()[0].centre - Vector3d(-3, 0, 0)).norm(), 1e-14);
  EXPECT_LT((pair.parts()[1].centre - Vector3d(1, 0, 0)).norm(), 1e-14);
}

TEST(Assembly, PartsAddUpByTheParallelAxisTheorem) {
  const Assembly dumbbell({brick({1, 1, 1}, 6, {0, 0, 7}), brick({1, 1, 1}, 3, {0, 0, 10})});
  expectMoments(dumbbell, 1.5 + 2 * 9, 1.5 + 2 * 9, 1.5);  // reduced mass 2, distance 3
  // A brick cut in eight is still the brick.
  std::vector<Solid> eighths;
  for (int i = 0; i < 8; ++i) {
    eighths.push_back(brick({0.5, 1, 1.5}, 1.5, {i & 1 ? 0.5 : 0, i & 2 ? 1. : 0, i & 4 ? 1.5 : 0}));
  }
  expectMoments(Assembly(eighths), 13, 10, 5);
}

TEST(Assembly, TurningItTurnsTheTensorAndShiftingItDoesNothing) {
  const Quaterniond turn = Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
  const Matrix3d r = turn.toRotationMatrix();
  for (const Assembly& assembly : oneOfEach()) {
    std::vector<Solid> moved = assembly.parts();
    for (Solid& part : moved) {
      part.centre = turn * part.centre + Vector3d(5, -6, 7);
      part.orientation = turn * part.orientation;
    }
    const Assembly other(moved);
    expectTensor(other, r * assembly.inertiaTensor() * r.transpose());
    EXPECT_NEAR(other.boundingRadius(), assembly.boundingRadius(), 1e-14);
  }
}

TEST(Assembly, MomentsAreThoseOfARealBody) {
  for (const Assembly& assembly : oneOfEach()) {
    const Vector3d m = Eigen::SelfAdjointEigenSolver<Matrix3d>(assembly.inertiaTensor()).eigenvalues();
    EXPECT_GT(m[0], 0);
    EXPECT_GE(m[0] + m[1], m[2]);
  }
}

TEST(Assembly, ScalesWithMassAndSize) {
  const Matrix3d one = shapes::wingnut(0.2, 0.5, {0.8, 0.1, 0.4}, 0.4, 1).inertiaTensor();
  expectTensor(shapes::wingnut(0.2, 0.5, {0.8, 0.1, 0.4}, 0.4, 3), 3 * one);
  expectTensor(shapes::wingnut(0.4, 1.0, {1.6, 0.2, 0.8}, 0.4, 1), 4 * one);
}

TEST(Assembly, RefusesWhatIsNotPositiveAndFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(Assembly(std::vector<Solid>{}), std::invalid_argument);
  for (const double bad : {0.0, -1.0, infinity, -infinity, std::nan("")}) {
    EXPECT_THROW(Assembly({brick({1, 1, 1}, bad)}), std::invalid_argument) << bad;
    for (int axis = 0; axis < 3; ++axis) {
      Vector3d size(1, 1, 1);
      size[axis] = bad;
      EXPECT_THROW(Assembly({brick(size, 1)}), std::invalid_argument) << bad;
      EXPECT_THROW(shapes::box(size, 1), std::invalid_argument) << bad;
      EXPECT_THROW(shapes::ellipsoid(size, 1), std::invalid_argument) << bad;
      EXPECT_THROW(shapes::wingnut(1, 1, size, 0, 1), std::invalid_argument) << bad;
    }
    EXPECT_THROW(shapes::box({1, 1, 1}, bad), std::invalid_argument) << bad;
    EXPECT_THROW(shapes::cylinder(bad, 1, 1), std::invalid_argument) << bad;
    EXPECT_THROW(shapes::cylinder(1, bad, 1), std::invalid_argument) << bad;
    EXPECT_THROW(shapes::tHandle(1, bad, 1, 1, 1), std::invalid_argument) << bad;
    EXPECT_THROW(shapes::tHandle(1, 1, 1, bad, 1), std::invalid_argument) << bad;
    EXPECT_THROW(shapes::lShape(bad, 2, 1, 1), std::invalid_argument) << bad;
    EXPECT_THROW(shapes::lShape(2, bad, 1, 1), std::invalid_argument) << bad;
    EXPECT_THROW(shapes::twoCylinders(1, 1, 1, bad, {0, 0, 0}, 1), std::invalid_argument) << bad;
  }
  EXPECT_THROW(shapes::lShape(2, 1, 1, 1), std::invalid_argument);  // no upright is left
}

TEST(Assembly, RefusalNamesTheValue) {
  try {
    shapes::box({1, -2.5, 1}, 1);
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("-2.5"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("positive"), std::string::npos) << error.what();
  }
}

TEST(Assembly, BoundingRadius) {
  EXPECT_DOUBLE_EQ(shapes::box({2, 4, 4}, 1).boundingRadius(), 3);
  EXPECT_DOUBLE_EQ(Assembly({brick({2, 4, 4}, 1, {9, 9, 9})}).boundingRadius(), 3);
  const Assembly pair({brick({2, 2, 2}, 1, {-5, 0, 0}), brick({2, 2, 2}, 1, {5, 0, 0})});
  EXPECT_DOUBLE_EQ(pair.boundingRadius(), std::sqrt(36 + 1 + 1));
  // Every corner of every part's box lies inside, and one on the sphere.
  for (const Assembly& assembly : oneOfEach()) {
    double furthest = 0;
    for (const Solid& part : assembly.parts()) {
      for (const double x : {-0.5, 0.5}) {
        for (const double y : {-0.5, 0.5}) {
          for (const double z : {-0.5, 0.5}) {
            const Vector3d corner(x * part.size.x(), y * part.size.y(), z * part.size.z());
            furthest = std::max(furthest, (part.orientation.toRotationMatrix() * corner + part.centre).norm());
          }
        }
      }
    }
    EXPECT_NEAR(assembly.boundingRadius(), furthest, 1e-14);
  }
}

TEST(Shapes, LShape) {
  // Bars 3×1×1 and 1×1×3, mass 3 each, centres (1, 0, 0) and (0, 0, 2).
  const double long_bar = 3 * 10 / 12.0, thin = 3 * 2 / 12.0, reduced = 1.5;
  Matrix3d expected;
  expected << thin + long_bar + reduced * 4, 0, reduced * 2,  //
      0, 2 * long_bar + reduced * 5, 0,                       //
      reduced * 2, 0, long_bar + thin + reduced * 1;
  expectTensor(shapes::lShape(3, 4, 1, 6), expected);
}

TEST(Shapes, LShapeFillsTheLOnce) {
  const Inside lying = [](const Vector3d& p) {
    return p.x() > -0.25 && p.x() < 1.25 && std::abs(p.y()) < 0.25 && std::abs(p.z()) < 0.25;
  };
  const Inside standing = [](const Vector3d& p) {
    return std::abs(p.x()) < 0.25 && std::abs(p.y()) < 0.25 && p.z() > -0.25 && p.z() < 1.75;
  };
  const Inside either = [&](const Vector3d& p) { return lying(p) || standing(p); };
  expectTensorWithin(0.01, shapes::lShape(1.5, 2, 0.5, 6), tensorByMonteCarlo({either}, 1.75, 6));
}

TEST(Shapes, THandle) {
  // Volumes 4π and 3π: masses 4 and 3; the stem's centre is 2.5 above the bar's.
  const double h2 = 2.5 * 2.5, reduced = 12.0 / 7;
  const double bar_across = 4 * (3 + 16) / 12.0, stem_across = 3 * (3 + 9) / 12.0;
  expectMoments(shapes::tHandle(1, 4, 1, 3, 7), bar_across + stem_across + reduced * h2, 2 + stem_across + reduced * h2,
                bar_across + 1.5);
  const Assembly handle = shapes::tHandle(1, 4, 1, 3, 7);
  EXPECT_LT(handle.parts()[0].centre.z(), handle.parts()[1].centre.z());
}

TEST(Shapes, TwoCylinders) {
  // Volumes 2π and 4π: masses 2 and 4; the second lies along x.
  const Vector3d d(0.5, -1, 2);
  const double reduced = 8.0 / 6, thin1 = 2 * 7 / 12.0, thin2 = 4 * 19 / 12.0;
  Matrix3d expected = Vector3d(thin1 + 2, thin1 + thin2, 1 + thin2).asDiagonal();
  expected += reduced * (5.25 * Matrix3d::Identity() - d * d.transpose());
  expectTensor(shapes::twoCylinders(1, 2, 1, 4, d, 6), expected);
}

TEST(Shapes, Wingnut) {
  const double dihedral = 0.5, c = std::cos(dihedral), s = std::sin(dihedral);
  const Inside hub = [](const Vector3d& p) { return std::hypot(p.x(), p.y()) < 0.22 && std::abs(p.z()) < 0.25; };
  const auto wing = [c, s](double side) {
    return [c, s, side](const Vector3d& p) {
      // Along the wing, which starts at 0.8 of the hub's radius and rises outwards, and across it.
      const double x = side * p.x() - 0.8 * 0.22;
      const double along = c * x + s * p.z() - 0.375, across = -s * x + c * p.z();
      return std::abs(p.y()) < 0.06 && std::pow(along / 0.375, 2) + std::pow(across / 0.225, 2) < 1;
    };
  };
  const Assembly wingnut = shapes::wingnut(0.22, 0.5, {0.75, 0.12, 0.45}, dihedral, 1);
  expectTensorWithin(0.01, wingnut, tensorByMonteCarlo({hub, wing(1), wing(-1)}, 0.95, 1));

  // Mirrored in x and in y: the body axes are principal; and the hub's is the intermediate one.
  const Matrix3d m = wingnut.inertiaTensor();
  EXPECT_TRUE(m.isDiagonal(1e-14)) << m;
  EXPECT_LT(m(0, 0), m(2, 2));
  EXPECT_LT(m(2, 2), m(1, 1));
}

TEST(Shapes, EquivalentBoxHasTheMomentsUpToScale) {
  for (const Vector3d& moments : {Vector3d(1, 2, 2.5), Vector3d(3, 1, 2.9), Vector3d(1, 1, 1),
                                  Vector3d(2e-7, 3e-7, 4e-7), Vector3d(4e200, 5e200, 3e200)}) {
    const Assembly stand_in = shapes::equivalentBox(moments, Quaterniond::Identity());
    const Matrix3d tensor = stand_in.inertiaTensor();
    const double scale = tensor(0, 0) / moments[0];
    EXPECT_LT((tensor - Matrix3d((scale * moments).asDiagonal())).norm(), 1e-13 * tensor.norm()) << moments;
    EXPECT_NEAR(stand_in.boundingRadius(), 1, 1e-14);
  }
}

TEST(Shapes, EquivalentBoxLiesAlongThePrincipalAxes) {
  const Quaterniond axes = Quaterniond(0.4, 0.3, -0.8, 0.1).normalized();
  const Vector3d moments(1, 2, 2.5);
  const Matrix3d tensor = shapes::equivalentBox(moments, axes).inertiaTensor();
  for (int i = 0; i < 3; ++i) {
    const Vector3d axis = axes * Vector3d::Unit(i);
    EXPECT_LT((tensor * axis - tensor.trace() * moments[i] / moments.sum() * axis).norm(), 1e-14);
  }
}

TEST(Shapes, EquivalentBoxOfImpossibleMomentsIsThin) {
  for (const Vector3d& moments : {Vector3d(1, 1, 10), Vector3d(1, 2, 3), Vector3d(100, 1, 1)}) {
    const Assembly stand_in = shapes::equivalentBox(moments, Quaterniond::Identity());
    const Vector3d size = stand_in.parts()[0].size;
    Eigen::Index largest, thinnest;
    moments.maxCoeff(&largest);
    size.minCoeff(&thinnest);
    EXPECT_EQ(thinnest, largest);
    EXPECT_GT(size[thinnest], 0);
    EXPECT_LT(size[thinnest], 0.05 * size.maxCoeff());
    EXPECT_NEAR(stand_in.boundingRadius(), 1, 1e-14);
  }
}
