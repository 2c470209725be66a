#pragma once

#include "poinsot/core/inertia.h"
#include "poinsot/view/layout.h"
#include "poinsot/view/picture_bounds.h"
#include "poinsot/view/picture_scale.h"

namespace poinsot::view {

/** How the two pictures of a body stand and how large they are drawn. */
struct PictureFrame {
  Layout layout;
  PictureScale scale;
  PictureBounds bounds;    ///< of a body under torques
  double title_depth = 0;  ///< of the titles below the centres [m]
};

/** Whether a picture that is drawn so still has a fair size when the body turns with Ω [rad/s, body axes]. */
bool hasFairSize(const PictureFrame& frame, const PrincipalInertia& inertia, const Eigen::Vector3d& omega_body);

}  // namespace poinsot::view
