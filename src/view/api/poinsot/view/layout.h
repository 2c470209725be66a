#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "poinsot/view/polhode.h"

namespace poinsot::view {

/**
 * Where the two pictures of Poinsot's construction stand beside their body, for a viewer who looks from +x (where
 * RViz's light is behind the viewer): the body, to its right (+y) the picture in world axes, then the one in body axes.
 */
struct Layout {
  Eigen::Vector3d space_centre;          ///< of the picture in world axes [m], world axes
  Eigen::Vector3d model_centre;          ///< of the picture in body axes [m], world axes
  Eigen::Quaterniond model_orientation;  ///< body axes → world: how the picture in body axes is turned to the viewer
};

/**
 * @param position of the body at t = 0 [m], world axes.
 * @param body_radius of a sphere that holds the body [m].
 * @param moments principal moments [kg·m²].
 * @param axes principal axes → body axes, unit.
 * @param polhode at t = 0.
 * @param omega_principal Ω at t = 0 [rad/s], principal axes.
 *
 * The picture in body axes is turned so that the polhode lies on the viewer's side: the axis that it goes round towards
 * the viewer, and some way to the side, the intermediate axis up. Of the two ends of the axis that is then at the side,
 * the one that `omega_later` is nearer to is turned to the viewer: where a body that loses energy arrives.
 *
 * @param omega_later_principal Ω at a later time [rad/s], principal axes; zero where it does not matter.
 */
Layout layoutOf(const Eigen::Vector3d& position, double body_radius, const Eigen::Vector3d& moments,
                const Eigen::Quaterniond& axes, const Polhode& polhode, const Eigen::Vector3d& omega_principal,
                const Eigen::Vector3d& omega_later_principal = Eigen::Vector3d::Zero());

}  // namespace poinsot::view
