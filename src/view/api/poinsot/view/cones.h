#pragma once

#include <Eigen/Core>
#include <optional>

namespace poinsot::view {

/**
 * The cones of a body with two equal moments: the one that ω sweeps in the body, about the axis of symmetry, and the
 * one that it sweeps in the world, about L. The first rolls on the second without slipping; they touch along ω. With A
 * the two equal moments and C the third, and θ the angle between the axis and L:
 *
 *     tan β = Ω⊥/|Ω₃|,   tan θ = (A/C) tan β,   σ = |θ − β|
 *
 * (Goldstein, Classical Mechanics, sections 5.6 and 5.7). The body cone rolls outside on the space cone where C < A,
 * around it where C > A.
 */
struct Cones {
  Eigen::Vector3d body_axis;  ///< principal axes, a unit vector: the end of the axis of symmetry that is nearer to Ω
  double body_angle = 0;      ///< β, half the opening [rad], < π/2
  double space_angle = 0;     ///< σ, half the opening about L [rad]
  bool around = false;        ///< whether C > A, so that the space cone is inside the body cone
};

/**
 * Returns the cones; nothing unless exactly two moments are equal and Ω is neither along the axis of symmetry nor
 * perpendicular to it.
 * @param moments [kg·m²], principal, positive, in any order.
 * @param omega_principal Ω [rad/s].
 */
std::optional<Cones> cones(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal);

}  // namespace poinsot::view
