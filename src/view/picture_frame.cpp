#include "poinsot/view/picture_frame.h"

#include "poinsot/view/ellipsoids.h"

namespace poinsot::view {
namespace {

constexpr double kSmallestSemiAxis = 0.55, kLargestSemiAxis = 1.35;  // radii of a picture, the longest of both

}  // namespace

PictureScale scaleInMetres(const PictureFrame& frame) {
  return {frame.unit * frame.scale.metres_per_radian_per_second, frame.unit * frame.scale.metres_per_angular_momentum};
}

bool hasFairSize(const PictureFrame& frame, const PrincipalInertia& inertia, const Eigen::Vector3d& omega_body) {
  const double drawn =
      frame.scale.metres_per_radian_per_second * longestSemiAxis(inertia.moments(), inertia.toPrincipal(omega_body));
  return drawn >= kSmallestSemiAxis && drawn <= kLargestSemiAxis;
}

bool isBehind(const PictureFrame& frame, const Eigen::Vector3d& omega_body) {
  return (frame.model_orientation * omega_body).x() < 0;
}

}  // namespace poinsot::view
