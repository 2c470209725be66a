#include "poinsot/view/picture_scale.h"

#include <cmath>

namespace poinsot::view {
namespace {

double orOne(double scale) {
  return scale > 0 && std::isfinite(scale) ? scale : 1.0;
}

}  // namespace

PictureScale pictureScale(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal) {
  const double largest = omega_principal.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return {};
  // |Λ| in two factors: squares of components leave the range of doubles long before the components do.
  const double unit_momentum = moments.cwiseProduct(omega_principal / largest).stableNorm();
  // The longest semi-axis is the momentum ellipsoid's, |Λ|/μmin: F = Σμᵢ²Ωᵢ² ≥ μmin·2E.
  return {orOne(kPictureRadius * (moments.minCoeff() / unit_momentum) / largest),
          orOne(kMomentumLength / unit_momentum / largest)};
}

PictureScale pictureScale(double longest_semi_axis, double momentum) {
  return {orOne(kPictureRadius / longest_semi_axis), orOne(kMomentumLength / momentum)};
}

}  // namespace poinsot::view
