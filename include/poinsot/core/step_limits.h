#pragma once

#include <string>

#include "poinsot/core/eigen_types.h"
#include "poinsot/core/method.h"
#include "poinsot/core/torques.h"

/** What a method cannot do: doc/hard_cases.md shows it measured. */
namespace poinsot {

/** How fast a free body moves, all along its orbit. */
struct OrbitRates {
  double turn;    ///< |Ω| never exceeds it, and comes near it unless the spin is steady [rad/s]
  double wobble;  ///< |L|(1/μ_min − 1/μ_max): L turns in the body at half of it at most [rad/s]; 0 for a sphere
  /** The larger of the two [rad/s]. */
  double fastest() const { return turn > wobble ? turn : wobble; }
};

/** For any |Ω|, also where its square leaves the range of doubles. */
OrbitRates orbitRates(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal);

/** How well a method follows a free body at a step. */
struct StepJudgement {
  /** The verdict. */
  enum class Grade {
    sound,     ///< nothing to say
    doubtful,  ///< to be used with a warning: `reason` says what is off, and by how much
    hopeless   ///< to be refused: what comes out is another motion than the body's
  };
  Grade grade = Grade::sound;  ///< the verdict
  std::string reason;          ///< a sentence without a full stop, with numbers; empty when sound
  double largest_sound = 0;    ///< a step [s] that is sound, at most |step|; 0 when none was found
};

/**
 * Judges by trial: takes steps from places all along the body's orbit (the polhode, its flip included, not only where
 * it starts) and compares with the closed form.
 *
 * hopeless: the attitude goes wrong by more than 1 rad within a turn of the body, or, where the body turns by more than
 * π a step, by more than 0.1 rad within a turn or step; or E (or its place in the range that |L| leaves it) or |L| by
 * more than half within a turn, or within 64 steps of more than 1 rad each; or the state becomes infinite or undefined.
 * doubtful: by more than 0.1 rad a turn; or E changes by more than a tenth; or the body turns by more than π a step and
 * is followed all the same, which happens where the motion is so regular that the method is nearly exact.
 *
 * Where a turn takes more than 64 steps, 64 from each place stand for all of it: errors of the attitude are taken to
 * grow in proportion, those of E exponentially.
 *
 * Costs milliseconds; nothing for steps that are clearly small. Never throws.
 *
 * @param method that moves free bodies.
 * @param moments principal moments [kg·m²], valid.
 * @param omega_principal at the start [rad/s], principal axes, finite.
 * @param step [s], of either sign, finite, not zero.
 */
StepJudgement judgeStep(const Method& method, const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal,
                        double step);

/**
 * The same for a body under torques, from its start only, where the truth is taylor24, which cuts its steps as needed:
 * hopeless where within 64 steps the attitude goes wrong by more than 1 rad or the state is lost; doubtful by more than
 * 0.1 rad. Methods of that family need no judgement. Never throws.
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
