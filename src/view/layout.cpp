#include "poinsot/view/layout.h"

#include <algorithm>

#include "poinsot/core/inertia.h"

namespace poinsot::view {
namespace {

constexpr double kGap = 0.25;          // between a body and the pictures [m]
constexpr double kPictureWidth = 2.6;  // a picture of radius 1 m and room for its arrows
constexpr double kTip = 0.25;          // rad, of the intermediate axis towards the viewer
constexpr double kTurn = 0.6;          // rad, of the axis that the polhode goes round, away from the viewer

/** Returns the rotation principal axes → world. */
Eigen::Quaterniond facingTheViewer(const Eigen::Vector3d& moments, Regime regime, const Eigen::Vector3d& omega,
                                   const Eigen::Vector3d& omega_later) {
  const auto [small, middle, large] = ascendingAxes(moments);
  const int front = regime == Regime::about_smallest ? small : large;
  const int side = small + large - front;
  Eigen::Matrix3d r = Eigen::Matrix3d::Zero();
  r(0, front) = omega[front] < 0 ? -1 : 1;
  r(2, middle) = 1;
  r(1, side) = 1;
  if (r.determinant() < 0) r(1, side) = -1;
  if (r(1, side) * omega_later[side] > 0) {  // kTurn turns +y away from the viewer
    r(1, side) = -r(1, side);
    r(2, middle) = -1;
  }
  return Eigen::AngleAxisd(kTurn, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(kTip, Eigen::Vector3d::UnitY()) *
         Eigen::Quaterniond(r);
}

}  // namespace

Layout layoutOf(const Eigen::Vector3d& position, double body_radius, const Eigen::Vector3d& moments,
                const Eigen::Quaterniond& axes, const Polhode& polhode, const Eigen::Vector3d& omega_principal,
                const Eigen::Vector3d& omega_later_principal) {
  const double first = body_radius + kGap + 0.5 * kPictureWidth;
  return {position + Eigen::Vector3d(0, first, 0), position + Eigen::Vector3d(0, first + kPictureWidth, 0),
          (facingTheViewer(moments, polhode.regime, omega_principal, omega_later_principal) * axes.conjugate())
              .normalized()};
}

}  // namespace poinsot::view
