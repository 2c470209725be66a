#pragma once

#include "poinsot/core/inertia.h"
#include "poinsot/view/layout.h"
#include "poinsot/view/picture_bounds.h"
#include "poinsot/view/picture_scale.h"

namespace poinsot::view {

/** Place and scale of the two pictures of a body. */
struct PictureFrame {
  Layout layout;
  PictureScale scale;
  PictureBounds bounds;    ///< of a body under torques
  double title_depth = 0;  ///< of the titles below the centres [m]
};

/** Returns whether the picture in that frame is neither too small nor too large for Ω [rad/s, body axes]. */
bool hasFairSize(const PictureFrame& frame, const PrincipalInertia& inertia, const Eigen::Vector3d& omega_body);

}  // namespace poinsot::view
