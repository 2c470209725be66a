#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "poinsot/core/inertia.h"
#include "poinsot/view/picture_bounds.h"
#include "poinsot/view/picture_scale.h"
#include "poinsot/view/scene_layout.h"

namespace poinsot::view {

/** Place, attitude and scale of the two pictures of a body. */
struct PictureFrame {
  BodyPlace place;
  Eigen::Quaterniond model_orientation = Eigen::Quaterniond::Identity();  ///< body axes → world, of that in body axes
  PictureScale scale;                                                     ///< of pictures with a radius of 1 m
  PictureBounds bounds;                                                   ///< of a body under torques
  std::optional<double> loop;     ///< of a scene that plays in rounds, the time of one [s]
  double unit = 1;                ///< radius of the pictures [m]
  double text = 1;                ///< heights of letters, relative to those in pictures that stand alone
  bool light_background = false;  ///< of the viewers
};

/** Returns the scale in metres. */
PictureScale scaleInMetres(const PictureFrame& frame);

/** Returns whether the picture in that frame is neither too small nor too large for Ω [rad/s, body axes]. */
bool hasFairSize(const PictureFrame& frame, const PrincipalInertia& inertia, const Eigen::Vector3d& omega_body);

/** Returns whether Ω [body axes] is on the side of the picture in body axes that a viewer at +x does not see. */
bool isBehind(const PictureFrame& frame, const Eigen::Vector3d& omega_body);

}  // namespace poinsot::view
