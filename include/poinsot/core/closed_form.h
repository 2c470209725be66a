#pragma once

#include <Eigen/Core>

#include "poinsot/core/closed_form_constants.h"
#include "poinsot/core/eigen_types.h"

namespace poinsot {

namespace closed_form {
struct Start;
}
/** The name by which scenes and programs ask for it. */
constexpr const char* kClosedForm = "closed_form";

/**
 * The free rigid body in closed form (Jacobi 1849): set up once, then the state at any time, in any order, at constant
 * cost. Method and sources: doc/closed_form.md.
 *
 * Inputs count as exact numbers, and the attitude is right to the last bits however long t is: set-up and phases are
 * carried in twice the precision of double. One path serves every body and start; see doc/closed_form.md for the
 * limits of it (steady spins, equal moments, the separatrix), which are recognised exactly.
 *
 * All axes here are the principal ones. A ClosedForm never changes; several threads may ask the same one. Nothing here
 * allocates, but for a few constants of Boost's, once in a process, made by the first start or time that is out of
 * double-double's reach: components of Ω or moments many orders of magnitude apart (2⁴⁸⁰, 2⁶⁰), or more than 2⁴⁴ turns.
 * Those cost a millisecond to some 20 ms each; all others microseconds (set-up) or nanoseconds.
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
   * The state at t [s], of either sign. Throws std::invalid_argument when t is not finite. Ω is infinite where it
   * leaves the range of doubles (a body with a tiny moment may spin far faster later on than at the start).
   */
  State at(double t) const;

  /**
   * out.row(j) = the state at t₀ + j·dt, that time taken exactly, not rounded to a double; out is all overwritten.
   * Vectorised for the processor that it runs on. Throws std::invalid_argument when t0 or dt is not finite.
   */
  void sample(double t0, double dt, Eigen::Ref<Samples> out) const {
    double* columns[7];
    for (int i = 0; i < 7; ++i) columns[i] = out.col(i).data();
    sample(t0, dt, out.rows(), columns);
  }

  /** The same into a table of its own, which the caller's code allocates: Eigen's allocator is not the same under every
   * flag. n ≥ 0. */
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
  /** Which of the three this motion is. */
  Regime regime() const;

  /**
   * Which axis the polhode goes round: 0, 1, 2. Steady: the axis of the spin where that is a principal axis.
   * −1 on the separatrix, for spins that are not about a principal axis, and at rest.
   */
  int encircledAxis() const;

  /**
   * How far from the separatrix the motion is: the complementary modulus k' = √(1 − k²) of its elliptic functions, 0 on
   * the separatrix and 1 where Ω moves on a circle (two equal moments, or an infinitely small polhode). For μ₁<μ₂<μ₃,
   * k'² = (μ₃−μ₁)|F−2Eμ₂| / ((μ₃−μ₂)(F−2Eμ₁)) about axis 3, and with 1 and 3 exchanged about axis 1.
   * Steady spins: 0 exactly on the unstable axis, else 1.
   */
  double separatrixDistance() const;

  /** The period of Ω [s], positive; infinite on the separatrix and for steady spins. */
  double period() const;

  /**
   * From t to the next instant at which the component of Ω along the axis of intermediate moment changes its sign: the
   * middle of a flip [s], > 0. Infinite when there is none: steady spins, two equal moments, the separatrix after its
   * only flip. Throws std::invalid_argument when t is not finite.
   */
  double timeToNextFlip(double t) const;

  /**
   * How far the body has turned about L when Ω has come back to where it was [rad], whole turns included; positive.
   * = 2E·T/|L| − the solid angle swept by L in body axes (Montgomery, Am. J. Phys. 59 (1991) 394), up to 2π.
   * NaN where period() is infinite.
   */
  double montgomeryAngle() const;

  /**
   * The mean rate at which the body turns about L [rad/s], ≥ 0: montgomeryAngle()/period(); on the separatrix and for a
   * spin about a principal axis |L|/μ of the axis where Ω tends to or is; 0 at rest. Other steady spins: |Ω|.
   */
  double precessionRate() const;

  /** The principal moments as they were given [kg·m²]. */
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
