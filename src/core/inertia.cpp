#include "poinsot/core/inertia.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <string>

#include "poinsot/core/number_text.h"
#include "refuse.h"

namespace poinsot {
namespace {

constexpr double kSymmetryTolerance = 1e-9;
constexpr double kSmallestMomentRatio = 1e-14;

}  // namespace

PrincipalInertia PrincipalInertia::fromMoments(const Eigen::Vector3d& moments) {
  const char* const names[] = {"moment 1", "moment 2", "moment 3"};
  for (int i = 0; i < 3; ++i) requirePositive(moments[i], names[i], "kg·m²");
  return {moments, Eigen::Quaterniond::Identity()};
}

PrincipalInertia PrincipalInertia::fromTensor(const Eigen::Matrix3d& tensor) {
  if (!tensor.allFinite())
    refuse("expected an inertia tensor of finite numbers (kg·m²), got one with an entry that is not finite");
  const double largest = tensor.cwiseAbs().maxCoeff();
  for (int i = 0; i < 3; ++i) {
    for (int j = i + 1; j < 3; ++j) {
      if (std::abs(tensor(i, j) - tensor(j, i)) > kSymmetryTolerance * largest) {
        refuse("the inertia tensor is not symmetric: entry (" + std::to_string(i + 1) + "," + std::to_string(j + 1) +
               ") is " + numberText(tensor(i, j), 17) + ", its mirror image " + numberText(tensor(j, i), 17));
      }
    }
  }
  const Eigen::Matrix3d symmetric = 0.5 * tensor + 0.5 * tensor.transpose();
  const Eigen::Vector3d diagonal = symmetric.diagonal();
  if (symmetric == Eigen::Matrix3d(diagonal.asDiagonal())) return fromMoments(diagonal);

  // The scale keeps all products inside the solver in the range of doubles.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric / largest);
  const Eigen::Vector3d& ratios = solver.eigenvalues();
  if (!(ratios[0] > kSmallestMomentRatio * ratios[2])) {
    refuse(std::string("the inertia tensor is not positive definite") + (ratios[0] > 0 ? " beyond roundoff" : "") +
           ": its principal moments are " + numberText(ratios[0] * largest, 17) + ", " +
           numberText(ratios[1] * largest, 17) + ", " + numberText(ratios[2] * largest, 17) + " kg·m²");
  }
  Eigen::Matrix3d vectors = solver.eigenvectors();
  if (vectors.determinant() < 0) vectors.col(0) = -vectors.col(0);
  return {ratios * largest, Eigen::Quaterniond(vectors).normalized()};
}

Eigen::Vector3d PrincipalInertia::toPrincipal(const Eigen::Vector3d& in_body) const {
  return axes_.conjugate() * in_body;
}

Eigen::Vector3d PrincipalInertia::toBody(const Eigen::Vector3d& in_principal) const {
  return axes_ * in_principal;
}

Eigen::Matrix3d PrincipalInertia::tensor() const {
  if (axes_.vec().isZero(0)) return moments_.asDiagonal();
  const Eigen::Matrix3d a = axes_.toRotationMatrix();
  const Eigen::Matrix3d m = a * moments_.asDiagonal() * a.transpose();
  return 0.5 * (m + m.transpose());
}

bool PrincipalInertia::satisfiesTriangleInequality() const {
  const double largest = moments_.maxCoeff();
  const Eigen::Vector3d ratios = moments_ / largest;  // no overflow in the sum
  return 2.0 - ratios.sum() <= 8 * std::numeric_limits<double>::epsilon();
}

}  // namespace poinsot
