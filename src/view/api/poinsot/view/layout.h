#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "poinsot/view/polhode.h"

namespace poinsot::view {

/**
 * The places of the two pictures of Poinsot's construction beside their body, for a viewer who looks from +x (in RViz
 * the light is then behind the viewer): the body, to its right (+y) the picture in world axes, then that in body axes.
 */
struct Layout {
  Eigen::Vector3d space_centre;          ///< of the picture in world axes [m], world axes
  Eigen::Vector3d model_centre;          ///< of the picture in body axes [m], world axes
  Eigen::Quaterniond model_orientation;  ///< body axes → world: how the picture in body axes is turned to the viewer
};

/**
 * Returns the layout of a body's pictures.
 *
 * The picture in body axes is turned so that the polhode lies on the viewer's side: the axis that it goes round points
 * towards the viewer and some way to the side, the intermediate axis upwards. Of the two ends of the third axis, the
 * one that is nearer to the later Ω is turned to the viewer: there, a body that loses energy arrives.
 *
 * @param position of the body at t = 0 [m], world axes.
 * @param body_radius of a sphere that holds the body [m].
 * @param moments principal moments [kg·m²].
 * @param axes principal axes → body axes, unit.
 * @param polhode at t = 0.
 * @param omega_principal Ω at t = 0 [rad/s], principal axes.
 * @param omega_later_principal Ω at a later time [rad/s], principal axes; zero where it does not matter.
 */
Layout layoutOf(const Eigen::Vector3d& position, double body_radius, const Eigen::Vector3d& moments,
                const Eigen::Quaterniond& axes, const Polhode& polhode, const Eigen::Vector3d& omega_principal,
                const Eigen::Vector3d& omega_later_principal = Eigen::Vector3d::Zero());

}  // namespace poinsot::view
