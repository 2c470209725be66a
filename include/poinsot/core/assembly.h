#pragma once

#include <vector>

#include "poinsot/core/eigen_types.h"

namespace poinsot {

/** The form of a Solid. */
enum class SolidType { box, ellipsoid, cylinder };

/** A homogeneous solid, placed in the axes of the assembly it belongs to. */
struct Solid {
  SolidType type = SolidType::box;  ///< its form
  /** Full extents along its own axes [m]; a cylinder's axis is z. Positive and finite. */
  Eigen::Vector3d size = Eigen::Vector3d::Ones();
  double mass = 1;                                   ///< [kg], positive and finite
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [m]
  Quaternion orientation = Quaternion::Identity();   ///< own axes → assembly axes, unit

  double volume() const;                  ///< its volume [m³]
  Eigen::Matrix3d inertiaTensor() const;  ///< about its own centre, in assembly axes [kg·m²]
};

/** Solids joined rigidly. The constructor moves them so that the origin is the centre of mass. */
class Assembly {
 public:
  /** Throws std::invalid_argument for no parts, and for sizes or masses that are not positive and finite. */
  explicit Assembly(std::vector<Solid> parts);

  /** The solids in the order given, placed about the common centre of mass. */
  const std::vector<Solid>& parts() const { return parts_; }
  double mass() const;                    ///< of all parts [kg]
  Eigen::Matrix3d inertiaTensor() const;  ///< about the centre of mass, by the parallel-axis theorem [kg·m²]
  double boundingRadius() const;          ///< of a sphere about the centre of mass that holds all parts' boxes [m]

 private:
  std::vector<Solid> parts_;
};

/**
 * Assemblies that scenes know by name. All parts have the same density. Lengths [m] and masses [kg] must be positive
 * and finite; std::invalid_argument is thrown otherwise.
 */
namespace shapes {

/** A box. @param size full extents along x, y and z [m] @param mass [kg] */
Assembly box(const Eigen::Vector3d& size, double mass);
/** An ellipsoid. @param size full extents (twice the semi-axes) along x, y and z [m] @param mass [kg] */
Assembly ellipsoid(const Eigen::Vector3d& size, double mass);
/** A cylinder about z. */
Assembly cylinder(double radius, double height, double mass);
/** A cylinder along y (the bar) with another, the stem, standing on its middle along z. */
Assembly tHandle(double bar_radius, double bar_length, double stem_radius, double stem_length, double mass);
/**
 * A hub (cylinder along z) with two wings in the xz plane that rise outwards by `dihedral` [rad]: flat elliptic discs
 * of extents `wing_size`, thin along y, rooted at 0.8 of the hub's radius. The hub's axis is the intermediate one for
 * usual proportions, so that a spinning wingnut flips.
 */
Assembly wingnut(double hub_radius, double hub_height, const Eigen::Vector3d& wing_size, double dihedral, double mass);
/** Two bars of square section `thickness`, one along x, one along z, that share a corner. */
Assembly lShape(double length_x, double length_z, double thickness, double mass);
/** A cylinder along z and, with its centre at `offset` from the first's, another along x. */
Assembly twoCylinders(double radius, double height, double second_radius, double second_height,
                      const Eigen::Vector3d& offset, double mass);
/**
 * Returns the homogeneous box with the ratios of these principal moments and a half diagonal of 1 m, to be drawn for a
 * body of which only the inertia is known. Its sides are wᵢ² ∝ μⱼ + μₖ − μᵢ, so that the longest lies along the axis of
 * smallest moment. Where no real body has such moments, the side that would be imaginary is thin.
 *
 * @param moments principal moments, positive and finite.
 * @param axes principal axes → assembly axes, unit.
 */
Assembly equivalentBox(const Eigen::Vector3d& moments, const Quaternion& axes);

}  // namespace shapes
}  // namespace poinsot
