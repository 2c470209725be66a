#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "poinsot/view/polhode.h"

namespace poinsot::view {

/**
 * Returns how the picture in body axes is turned to a viewer who looks from +x (in RViz the light is then behind him):
 * the rotation body axes → world.
 *
 * The polhode lies on the viewer's side: the axis that it goes round points towards the viewer and some way to the
 * side, the intermediate axis upwards. Of the two ends of the third axis, the one that is nearer to the later Ω is
 * turned to the viewer: there, a body that loses energy arrives.
 *
 * @param moments principal moments [kg·m²].
 * @param axes principal axes → body axes, unit.
 * @param polhode at t = 0.
 * @param omega_principal Ω at t = 0 [rad/s], principal axes.
 * @param omega_later_principal Ω at a later time [rad/s], principal axes; zero where it does not matter.
 */
Eigen::Quaterniond facingTheViewer(const Eigen::Vector3d& moments, const Eigen::Quaterniond& axes,
                                   const Polhode& polhode, const Eigen::Vector3d& omega_principal,
                                   const Eigen::Vector3d& omega_later_principal = Eigen::Vector3d::Zero());

}  // namespace poinsot::view
