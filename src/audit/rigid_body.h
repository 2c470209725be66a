#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "poinsot/audit/effects.h"

/** The audit's own physics of a rigid body, free or under torques, in any body axes. It shares no code with that of
 * the node. */
namespace poinsot::audit {

/** Returns exp of a rotation vector [rad]. */
Eigen::Quaterniond rotationBy(const Eigen::Vector3d& theta);

/** Returns the rotation vector [rad] of a unit quaternion, |θ| ≤ π. */
Eigen::Vector3d rotationVector(const Eigen::Quaterniond& q);

struct Inertia {
  explicit Inertia(const Eigen::Matrix3d& tensor);

  Eigen::Matrix3d tensor, inverse;
  Eigen::Vector3d moments;  ///< ascending

  double energy(const Eigen::Vector3d& omega_body) const { return 0.5 * omega_body.dot(tensor * omega_body); }
  /** Returns |L|/μ_min [rad/s]: no free motion of that momentum turns faster. */
  double fastestRate(const Eigen::Vector3d& omega_body) const { return (tensor * omega_body).norm() / moments[0]; }
  /** Returns the rate at which neighbouring free motions can part [1/s], exponentially near the unstable axis. */
  double partingRate(const Eigen::Vector3d& omega_body) const;
  /** Return by how much relative errors of Ω and M are amplified in E and in L: 1 for a sphere, up to μ_max/μ_min. */
  double conditionOfEnergy(const Eigen::Vector3d& omega_body) const;
  double conditionOfMomentum(const Eigen::Vector3d& omega_body) const;
};

/** Attitude and rates of a body. S is double, or a power series in time. */
template <class S>
struct PhaseOf {
  Eigen::Quaternion<S> attitude;                                       ///< body → world, unit
  Eigen::Matrix<S, 3, 1> omega;                                        ///< Ω [rad/s], body axes
  Eigen::Matrix<S, 3, 1> slug_omega = Eigen::Matrix<S, 3, 1>::Zero();  ///< σ [rad/s], body axes; zero without a slug
};
using Phase = PhaseOf<double>;

/** A phase some time later, and impulse and work of the torques until then. */
struct Travelled {
  Phase end;
  Eigen::Vector3d impulse;  ///< ∫ of the external torques, world axes [kg·m²/s]
  double work;              ///< ∫ Ω·(all torques on the body) [J]: the gain of E
};

/** A body and the effects on it; free where there are none. */
class RigidBody {
 public:
  RigidBody(const Inertia& inertia, const Effects& effects) : inertia_(inertia), effects_(effects) {}

  const Inertia& inertia() const { return inertia_; }
  const Effects& effects() const { return effects_; }
  double slugInertia() const { return effects_.slug ? effects_.slug->inertia : 0; }

  /** Returns E of the body without its slug [J]. */
  double energy(const Phase& p) const { return inertia_.energy(p.omega); }
  /** Returns L of body and slug together [kg·m²/s], world axes. */
  Eigen::Vector3d momentum(const Phase& p) const;

  /** Returns a bound of the external torques, at this attitude or any other [N·m]. */
  double torqueScale(double t, const Phase& p) const;
  /** Returns a bound of |Ω| near a phase [rad/s], |Λ|/μ_min + √(|τ|/μ_min), to which errors of Ω are relative. */
  double speed(double t, const Phase& p) const;
  /** Returns the same with the rates of damping, slug and orbit added [1/s]. */
  double rate(double t, const Phase& p) const;

  /**
   * Integrates MΩ̇ = MΩ×Ω + τ, J(σ̇ + Ω×σ) = c(Ω − σ) and the attitude over `duration` [s, either sign] from t on, by the
   * classical Runge–Kutta method in substeps of at most `angle` [rad] at rate(), which end where a torque is switched.
   * Returns nothing where that would take more than 200 000 substeps.
   */
  std::optional<Travelled> travel(double t, const Phase& start, double duration, double angle) const;

  /** Returns how many substeps of `angle` [rad] that takes. */
  double substeps(double t, const Phase& start, double duration, double angle) const;

  /**
   * Returns the terms aₖhᵏ of the motion's Taylor series about t, k = 0 … count−1 (count ≤ 28): of each the largest of
   * |q|, |Ω|/speed and |σ|/speed. Times at which a torque is switched are not taken into account.
   */
  std::vector<double> taylorTerms(double t, const Phase& p, double h, int count) const;

 private:
  Inertia inertia_;
  Effects effects_;
};

/**
 * The growth of errors along a motion: neighbours that start a little off in attitude, Ω or σ travel along.
 */
class Neighbours {
 public:
  /** @param body must outlive this */
  Neighbours(const RigidBody& body, double t, const Phase& start);

  /** Moves all of them on. Returns false where that would take too many substeps. */
  bool travel(double t, double duration);

  /**
   * Returns by how much a quantity differs now for errors of 1 (rad, rad/s) at the start, summed over all components.
   * @param difference of that quantity between two phases, a number.
   */
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
