#include "poinsot/view/facing.h"

#include "poinsot/core/inertia.h"

namespace poinsot::view {
namespace {

constexpr double kTip = 0.25;  // rad, of the intermediate axis towards the viewer
constexpr double kTurn = 0.6;  // rad, of the axis that the polhode goes round, away from the viewer

}  // namespace

Eigen::Quaterniond facingTheViewer(const Eigen::Vector3d& moments, const Eigen::Quaterniond& axes,
                                   const Polhode& polhode, const Eigen::Vector3d& omega_principal,
                                   const Eigen::Vector3d& omega_later_principal) {
  const auto [small, middle, large] = ascendingAxes(moments);
  const int front = polhode.regime == Regime::about_smallest ? small : large;
  const int side = small + large - front;
  Eigen::Matrix3d r = Eigen::Matrix3d::Zero();
  r(0, front) = omega_principal[front] < 0 ? -1 : 1;
  r(2, middle) = 1;
  r(1, side) = 1;
  if (r.determinant() < 0) r(1, side) = -1;
  if (r(1, side) * omega_later_principal[side] > 0) {  // kTurn turns +y away from the viewer
    r(1, side) = -r(1, side);
    r(2, middle) = -1;
  }
  const Eigen::Quaterniond principal_to_world = Eigen::AngleAxisd(kTurn, Eigen::Vector3d::UnitZ()) *
                                                Eigen::AngleAxisd(kTip, Eigen::Vector3d::UnitY()) *
                                                Eigen::Quaterniond(r);
  return (principal_to_world * axes.conjugate()).normalized();
}

}  // namespace poinsot::view
