#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "poinsot/core/eigen_types.h"
#include "poinsot/core/inertia.h"

namespace poinsot {

/** The axes in which a vector is constant. */
enum class Axes { body, world };

/**
 * The sum of the effects on a body: the torque τ(t, R, Ω, σ) about its centre of mass or its pivot, as a sum of a few
 * kinds of terms. Each effect (effects/) adds some of them; integrators need to know only these:
 *
 *   τ = b(t) + Σᵢ Aᵢ Rᵀxᵢ(t) + 3n² u×(Mu) − DΩ − c(Ω − σ)
 *
 * with b constant in the body and x₀ in the world, piecewise in time; xᵢ other world vectors and Aᵢ matrices; u =
 * Rᵀr(t) the direction r from the centre of an orbit of rate n; D a damping matrix; σ the rate of a slug inside, J(σ̇ +
 * Ω×σ) = c(Ω − σ).
 *
 * All terms are held in principal axes, in SI units.
 */
class Torques {
 public:
  /** No torques yet on a body of that inertia. */
  explicit Torques(const PrincipalInertia& inertia);

  // For effects. Vectors "in body axes" refer to those in which the inertia was given. These functions throw
  // std::invalid_argument where a term excludes one that is already there, or a value is not finite or out of range.

  /** Adds a torque for all t. @param axes in which it is constant @param torque [N·m], finite */
  void addConstant(Axes axes, const Eigen::Vector3d& torque) {
    addBetween(-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), axes, torque);
  }
  /**
   * Adds a torque for from ≤ t < to.
   * @param from,to [s], from < to; infinite where there is no end.
   * @param axes in which it is constant.
   * @param torque [N·m], finite.
   */
  void addBetween(double from, double to, Axes axes, const Eigen::Vector3d& torque);
  /**
   * Adds a force that is constant in the world, at a point fixed in the body: τ = lever × Rᵀforce.
   * @param lever of the point, body axes [m], finite.
   * @param force_world world axes [N], finite.
   */
  void addForce(const Eigen::Vector3d& lever, const Eigen::Vector3d& force_world);
  /**
   * Adds the gravity gradient of a circular orbit, of which a body has at most one.
   * @param orbit_rate n [rad/s], positive and finite.
   * @param normal,radial_at_start world directions, perpendicular to 1e-9 rad, of any length but 0.
   */
  void addGravityGradient(double orbit_rate, const Eigen::Vector3d& normal, const Eigen::Vector3d& radial_at_start);
  /** Adds τᵢ = −cᵢΩᵢ along each body axis. @param coefficients c [N·m·s], finite, not negative */
  void addDamping(const Eigen::Vector3d& coefficients);
  /** Adds a slug, at most one. @param inertia J [kg·m²], positive and finite @param damping c [N·m·s], finite, not
   * negative */
  void addSlug(double inertia, double damping);

  /** Throws std::invalid_argument where the sum, or an acceleration it may give, is beyond the range of doubles. */
  void requireFinite() const;

  // For integrators. All in principal axes.

  /** The part of τ that is piecewise constant in time: constant in the body, and x₀ in the world. */
  struct Constant {
    Eigen::Vector3d body = Eigen::Vector3d::Zero();   ///< b [N·m], principal axes
    Eigen::Vector3d world = Eigen::Vector3d::Zero();  ///< x₀ [N·m], world axes
  };
  /** A world vector x and the matrix A by which it becomes a torque, A Rᵀx. */
  struct Field {
    Eigen::Vector3d world;  ///< x, world axes; of a force [N]
    Eigen::Matrix3d map;    ///< A, to principal axes; of a force hat(lever) [m]
  };
  /** A circular orbit in a central field. */
  struct Gradient {
    double rate;                               ///< n [rad/s]
    Eigen::Vector3d normal;                    ///< N, world axes, unit, as all directions here
    Eigen::Vector3d radial;                    ///< r(0)
    Eigen::Vector3d along;                     ///< N × r(0)
    Eigen::Vector3d radialAt(double t) const;  ///< r(t) = radial cos nt + along sin nt, t in s
    Eigen::Vector3d alongAt(double t) const;   ///< ṙ/n
  };
  /** A slug inside, as InternalDissipation describes it. */
  struct Slug {
    double inertia;  ///< J [kg·m²]
    double damping;  ///< c [N·m·s]
  };

  /** Returns the body's principal moments [kg·m²]. */
  const Eigen::Vector3d& moments() const { return moments_; }

  /** Returns whether nothing acts. */
  bool none() const;

  /** Returns the times at which Constant changes, ascending [s]. */
  const std::vector<double>& switches() const { return switches_; }
  /** Returns the Constant of interval k, between switches k−1 and k, of which there is one more than of switches. */
  const Constant& constant(std::size_t interval) const { return constants_[interval]; }
  /** Returns the interval in which t [s] lies; at a switch the later one. */
  std::size_t intervalAt(double t) const;
  /** Returns whether a torque that is constant in world axes was added. */
  bool hasWorldConstant() const { return has_world_; }
  /** Returns the forces, at most three: more are combined. */
  const std::vector<Field>& fields() const { return fields_; }
  /** Returns the orbit, if there is one. */
  const std::optional<Gradient>& gradient() const { return gradient_; }
  /** Returns D [N·m·s], if there is damping from outside. */
  const std::optional<Eigen::Matrix3d>& damping() const { return damping_; }
  /** Returns the slug, if there is one. */
  const std::optional<Slug>& slug() const { return slug_; }

  /** Returns whether τ depends on t and R alone: nothing is damped. */
  bool dependsOnAttitudeOnly() const { return !damping_ && !slug_; }
  /** Returns whether all torques are constant in the world, so that L(t) is known; with a slug, the sum of both. */
  bool momentumIsKnown() const;
  /** Returns what those torques add to L from 0 to t [kg·m²/s, world axes]. */
  Eigen::Vector3d impulseWorld(double t) const;

  /**
   * Returns τ on the body [N·m].
   * @param t [s].
   * @param constant of the interval in which t lies.
   * @param attitude R: principal axes → world, unit.
   * @param omega Ω [rad/s].
   * @param slug_omega σ [rad/s]; not looked at where there is no slug.
   */
  Eigen::Vector3d at(double t, const Constant& constant, const Quaternion& attitude, const Eigen::Vector3d& omega,
                     const Eigen::Vector3d& slug_omega) const;
  /** Returns σ̇ [rad/s²]; zero where there is no slug. */
  Eigen::Vector3d slugAcceleration(const Eigen::Vector3d& omega, const Eigen::Vector3d& slug_omega) const;

 private:
  Eigen::Vector3d principal(const Eigen::Vector3d& body) const { return axes_.conjugate() * body; }

  Eigen::Vector3d moments_;
  Quaternion axes_;  ///< principal → body
  std::vector<double> switches_;
  std::vector<Constant> constants_ = {Constant()};
  bool has_world_ = false;
  std::vector<Field> fields_;
  std::optional<Gradient> gradient_;
  std::optional<Eigen::Matrix3d> damping_;
  std::optional<Slug> slug_;
};

}  // namespace poinsot
