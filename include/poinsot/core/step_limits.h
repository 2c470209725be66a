#pragma once

#include <string>

#include "poinsot/core/eigen_types.h"
#include "poinsot/core/method.h"
#include "poinsot/core/torques.h"

/** Whether a step is short enough for a method and a body; doc/hard_cases.md shows measurements. */
namespace poinsot {

/** How fast a free body moves, all along its orbit. */
struct OrbitRates {
  double turn;    ///< an upper bound of |Ω| [rad/s], reached or nearly reached unless the spin is steady
  double wobble;  ///< |L|(1/μ_min − 1/μ_max) [rad/s], 0 for a sphere: L turns in the body at no more than half of it
  /** Returns the larger of the two [rad/s]. */
  double fastest() const { return turn > wobble ? turn : wobble; }
};

/**
 * Returns the rates of the orbit through Ω; also where |Ω|² leaves the range of doubles.
 * @param moments principal moments [kg·m²], valid.
 * @param omega_principal Ω [rad/s], principal axes, finite.
 */
OrbitRates orbitRates(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal);

/** How well a method follows a body with steps of one length. */
struct StepJudgement {
  /** The verdict. */
  enum class Grade {
    sound,     ///< without a flaw worth a warning
    doubtful,  ///< to be used with a warning: `reason` says what goes wrong, and by how much
    hopeless   ///< to be refused: the result is not the motion of the body
  };
  Grade grade = Grade::sound;  ///< the verdict
  std::string reason;          ///< a clause with figures, without a full stop; empty when sound
  double largest_sound = 0;    ///< a step [s] that is sound, at most |step|; 0 when none was found
};

/**
 * Judges a step of a free body by trial: takes steps from places all along its orbit (the polhode with its flip, not
 * only the start) and compares them with the closed form.
 *
 * hopeless:
 * - the attitude goes wrong by more than 1 rad in a turn of the body, or, where a step turns the body by more than π,
 * by more than 0.1 rad in a turn or step;
 * - E, its place in the range that |L| leaves it, or |L| goes wrong by more than half in a turn, or within 64 steps of
 *   more than 1 rad each;
 * - the state becomes infinite or undefined.
 *
 * doubtful:
 * - the attitude goes wrong by more than 0.1 rad in a turn, or E by more than a tenth;
 * - a step turns the body by more than π, and the method follows only because the motion is so regular that it is
 *   nearly exact.
 *
 * Where a turn takes more than 64 steps, its error is extrapolated from 64 steps from each place: that of the attitude
 * in proportion, that of E exponentially.
 *
 * Takes milliseconds, but no time for steps that are clearly small. Never throws.
 *
 * @param method that moves free bodies.
 * @param moments principal moments [kg·m²], valid.
 * @param omega_principal at the start [rad/s], principal axes, finite.
 * @param step [s], of either sign, finite, not zero.
 */
StepJudgement judgeStep(const Method& method, const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal,
                        double step);

/**
 * Judges a step of a body under torques by 64 steps from its start, compared with taylor24, which divides its steps as
 * needed. hopeless: the attitude goes wrong by more than 1 rad, or the state becomes infinite or undefined; doubtful:
 * the attitude goes wrong by more than 0.1 rad. Methods that divide their steps are always sound. Never throws.
 *
 * @param method that takes these torques.
 * @param torques that act on the body; its moments are theirs.
 * @param attitude R at the start, principal axes → world, unit.
 * @param omega_principal at the start [rad/s], principal axes, finite.
 * @param step [s], of either sign, finite, not zero.
 */
StepJudgement judgeStep(const Method& method, const Torques& torques, const Quaternion& attitude,
                        const Eigen::Vector3d& omega_principal, double step);

}  // namespace poinsot
