#pragma once

#include <Eigen/Core>

#include "poinsot/core/closed_form_constants.h"
#include "poinsot/core/eigen_types.h"

namespace poinsot {

namespace closed_form {
struct Start;
}
/** The name of the closed form in scenes and programs. */
constexpr const char* kClosedForm = "closed_form";

/**
 * The free rigid body in closed form (Jacobi 1849): set up once, then the state at any time, in any order, at constant
 * cost. Method and sources: doc/closed_form.md.
 *
 * Inputs count as exact numbers, and the attitude is right to the last bits for any t: set-up and phases have twice the
 * precision of a double. One path serves every body and start; its limits (steady spins, equal moments, the separatrix)
 * are recognised exactly, see doc/closed_form.md.
 *
 * All axes here are the principal ones. A ClosedForm never changes, so several threads may use the same one. A set-up
 * takes microseconds, a state nanoseconds, and neither allocates. The exceptions are starts and times beyond the reach
 * of double-double numbers: components of Ω 2⁴⁸⁰ apart, moments 2⁶⁰ apart, or more than 2⁴⁴ turns. Each of these takes
 * 1 to 20 ms, and the first in a process allocates some constants of Boost's.
 */
class ClosedForm {
 public:
  /** The motion at one time. */
  struct State {
    Quaternion attitude;  ///< R: principal axes → world, unit to roundoff; continuous in t, so of either sign
    Eigen::Vector3d omega_principal;  ///< Ω [rad/s], principal axes
  };

  /** One state a row: w, x, y, z of the attitude, then Ω₁, Ω₂, Ω₃ [rad/s]. Column by column in memory. */
  using Samples = Eigen::Matrix<double, Eigen::Dynamic, 7>;

  /**
   * @param moments principal moments [kg·m²], positive and finite, in any order, physical or not.
   * @param attitude at t = 0, principal axes → world; of any length but zero, normalised exactly.
   * @param omega_principal at t = 0 [rad/s], principal axes, finite.
   * Throws std::invalid_argument for anything else.
   */
  ClosedForm(const Eigen::Vector3d& moments, const Quaternion& attitude, const Eigen::Vector3d& omega_principal);

  /**
   * Returns the state at t [s], of either sign. Throws std::invalid_argument when t is not finite. Ω is infinite where
   * it leaves the range of doubles (a body with a tiny moment may spin far faster later on than at the start).
   */
  State at(double t) const;

  /**
   * Writes the state at t₀ + j·dt [s] to row j, for all rows of `out`; that time is not rounded to a double. Vectorised
   * for the processor that it runs on. Throws std::invalid_argument when t0 or dt is not finite.
   */
  void sample(double t0, double dt, Eigen::Ref<Samples> out) const {
    double* columns[7];
    for (int i = 0; i < 7; ++i) columns[i] = out.col(i).data();
    sample(t0, dt, out.rows(), columns);
  }

  /** The same, into a new table of n ≥ 0 rows. Inline, because Eigen's allocator depends on the compiler's flags. */
  Samples sample(double t0, double dt, Eigen::Index n) const {
    Samples out(n, 7);
    sample(t0, dt, out);
    return out;
  }

  /** The same into plain memory: columns[i][j] is quantity i, in the order of Samples, of sample j. */
  void sample(double t0, double dt, std::int64_t n, double* const columns[7]) const;

  /** What the motion is, decided exactly. */
  enum class Regime {
    steady,   ///< Ω is constant in the body: rest, a sphere, a spin about a principal axis or across two equal moments
    general,  ///< Ω is periodic and goes round one axis
    separatrix  ///< Ω runs from one end of the axis of intermediate moment to the other, once
  };
  /** Returns which of the three this motion is. */
  Regime regime() const;

  /**
   * Returns the axis that the polhode goes round, 0, 1 or 2; of a steady spin the principal axis that it is about.
   * −1 on the separatrix, for steady spins about another axis, and at rest.
   */
  int encircledAxis() const;

  /**
   * Returns how far the motion is from the separatrix: the complementary modulus k' = √(1 − k²) of its elliptic
   * functions, 0 on the separatrix and 1 where Ω moves on a circle (two equal moments, or an infinitely small polhode).
   * For μ₁<μ₂<μ₃, k'² = (μ₃−μ₁)|F−2Eμ₂| / ((μ₃−μ₂)(F−2Eμ₁)) about axis 3, and with 1 and 3 exchanged about axis 1.
   * Steady spins: 0 exactly on the unstable axis, else 1.
   */
  double separatrixDistance() const;

  /** Returns the period of Ω [s], positive; infinite on the separatrix and for steady spins. */
  double period() const;

  /**
   * Returns the time from t to the middle of the next flip [s], > 0: the next instant at which the component of Ω along
   * the axis of intermediate moment changes its sign. Infinite when there is none: steady spins, two equal moments, the
   * separatrix after its only flip. Throws std::invalid_argument when t is not finite.
   */
  double timeToNextFlip(double t) const;

  /**
   * Returns the angle by which the body turns about L in a period [rad], whole turns included; positive:
   * 2E·T/|L| − the solid angle swept by L in body axes (Montgomery, Am. J. Phys. 59 (1991) 394), up to 2π.
   * NaN where period() is infinite.
   */
  double montgomeryAngle() const;

  /**
   * Returns the mean rate at which the body turns about L [rad/s], ≥ 0: montgomeryAngle()/period(); on the separatrix
   * and for a spin about a principal axis |L|/μ of the axis where Ω tends to or is; 0 at rest. Other steady spins: |Ω|.
   */
  double precessionRate() const;

  /** Returns the principal moments as they were given [kg·m²]. */
  const Eigen::Vector3d& moments() const { return moments_; }

 private:
  closed_form::Start start() const;
  double fromScaledTime(double t) const;

  Eigen::Vector3d moments_;
  Quaternion attitude_;
  Eigen::Vector3d omega_principal_;
  closed_form::Constants constants_;
};

}  // namespace poinsot
