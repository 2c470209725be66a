#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "poinsot/audit/effects.h"

/** The audit's own physics of a rigid body, free or under torques, in body axes (any). Shares no code with the node's.
 */
namespace poinsot::audit {

/** exp of a rotation vector [rad]. */
Eigen::Quaterniond rotationBy(const Eigen::Vector3d& theta);

/** The rotation vector [rad] of a unit quaternion, |θ| ≤ π. */
Eigen::Vector3d rotationVector(const Eigen::Quaterniond& q);

struct Inertia {
  explicit Inertia(const Eigen::Matrix3d& tensor);

  Eigen::Matrix3d tensor, inverse;
  Eigen::Vector3d moments;  ///< ascending

  double energy(const Eigen::Vector3d& omega_body) const { return 0.5 * omega_body.dot(tensor * omega_body); }
  /** |L|/μ_min: no free motion of that momentum turns faster [rad/s]. */
  double fastestRate(const Eigen::Vector3d& omega_body) const { return (tensor * omega_body).norm() / moments[0]; }
  /** How fast two neighbouring free motions can part: exponentially near the unstable axis [1/s]. */
  double partingRate(const Eigen::Vector3d& omega_body) const;
  /** What rounding Ω and M once does to E and to L, relatively: 1 for a sphere, up to about μ_max/μ_min. */
  double conditionOfEnergy(const Eigen::Vector3d& omega_body) const;
  double conditionOfMomentum(const Eigen::Vector3d& omega_body) const;
};

/** Where a body is. S is double, or a power series in time. */
template <class S>
struct PhaseOf {
  Eigen::Quaternion<S> attitude;                                       ///< body → world, unit
  Eigen::Matrix<S, 3, 1> omega;                                        ///< Ω [rad/s], body axes
  Eigen::Matrix<S, 3, 1> slug_omega = Eigen::Matrix<S, 3, 1>::Zero();  ///< σ [rad/s], body axes; zero without a slug
};
using Phase = PhaseOf<double>;

/** A phase some time later, and what acted in between. */
struct Travelled {
  Phase end;
  Eigen::Vector3d impulse;  ///< ∫ of the external torques, world axes [kg·m²/s]
  double work;              ///< ∫ Ω·(all torques on the body) [J]: what E has gained
};

/** A body and what acts on it; free where nothing does. */
class RigidBody {
 public:
  RigidBody(const Inertia& inertia, const Effects& effects) : inertia_(inertia), effects_(effects) {}

  const Inertia& inertia() const { return inertia_; }
  const Effects& effects() const { return effects_; }
  double slugInertia() const { return effects_.slug ? effects_.slug->inertia : 0; }

  /** E of the body alone [J]. */
  double energy(const Phase& p) const { return inertia_.energy(p.omega); }
  /** L, of body and slug together, world axes. */
  Eigen::Vector3d momentum(const Phase& p) const;

  /** How large the external torques are, or would be at another attitude [N·m]. */
  double torqueScale(double t, const Phase& p) const;
  /** How fast Ω may be here [rad/s]: |Λ|/μ_min + √(|τ|/μ_min). What errors of Ω are relative to. */
  double speed(double t, const Phase& p) const;
  /** The same and whatever else there is to follow: damping, the slug's, the orbit's [1/s]. */
  double rate(double t, const Phase& p) const;

  /**
   * MΩ̇ = MΩ×Ω + τ, J(σ̇ + Ω×σ) = c(Ω − σ) and the attitude, over `duration` [s, either sign] from t, by the classical
   * Runge–Kutta method in substeps of at most `angle` at rate(); where a torque is switched, a substep ends. Nothing
   * where more than 200 000 substeps would be needed.
   */
  std::optional<Travelled> travel(double t, const Phase& start, double duration, double angle) const;

  /** How many substeps of `angle` that takes. */
  double substeps(double t, const Phase& start, double duration, double angle) const;

  /**
   * The terms aₖhᵏ of the motion's Taylor series about t: the largest of |q|, |Ω|/speed, |σ|/speed, for k = 0 … count−1
   * (count ≤ 28), by recurrence. Times at which a torque is switched are not looked at.
   */
  std::vector<double> taylorTerms(double t, const Phase& p, double h, int count) const;

 private:
  Inertia inertia_;
  Effects effects_;
};

/**
 * How what is uncertain at the start of a motion shows later: neighbours that start a little off in attitude, Ω and σ
 * travel along.
 */
class Neighbours {
 public:
  /** @param body must outlive this */
  Neighbours(const RigidBody& body, double t, const Phase& start);

  /** False where that would take too many substeps. */
  bool travel(double t, double duration);

  /** By how much something differs now where each part of the start was off by 1 (rad, speed): summed over the parts.
   * @param difference of two phases, a number */
  template <class Difference>
  double growth(const Difference& difference) const {
    double sum = 0;
    for (std::size_t i = 1; i < phases_.size(); ++i) sum += difference(phases_[i], phases_[0]) / kOff;
    return sum;
  }

 private:
  static constexpr double kOff = 1e-5;
  const RigidBody* body_;
  std::vector<Phase> phases_;
};

}  // namespace poinsot::audit
