#include "poinsot/view/picture_frame.h"

#include "poinsot/view/ellipsoids.h"

namespace poinsot::view {
namespace {

constexpr double kSmallestSemiAxis = 0.55, kLargestSemiAxis = 1.35;  // m, the longest of both ellipsoids

}  // namespace

bool hasFairSize(const PictureFrame& frame, const PrincipalInertia& inertia, const Eigen::Vector3d& omega_body) {
  const double drawn =
      frame.scale.metres_per_radian_per_second * longestSemiAxis(inertia.moments(), inertia.toPrincipal(omega_body));
  return drawn >= kSmallestSemiAxis && drawn <= kLargestSemiAxis;
}

}  // namespace poinsot::view
