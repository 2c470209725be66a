#include "poinsot/view/picture_frame.h"

namespace poinsot::view {
namespace {

constexpr double kSmallestSemiAxis = 0.55, kLargestSemiAxis = 1.35;  // m, the longest of the two ellipsoids'

}  // namespace

bool hasFairSize(const PictureFrame& frame, const PrincipalInertia& inertia, const Eigen::Vector3d& omega_body) {
  const Eigen::Vector3d momentum = inertia.moments().cwiseProduct(inertia.toPrincipal(omega_body));
  const double drawn =
      frame.scale.metres_per_radian_per_second * (momentum.stableNorm() / inertia.moments().minCoeff());
  return drawn >= kSmallestSemiAxis && drawn <= kLargestSemiAxis;
}

}  // namespace poinsot::view
