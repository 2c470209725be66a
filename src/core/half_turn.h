#pragma once

#include "poinsot/core/eigen_types.h"

/** exp(θ) for steppers, inline because they need it at least once a step. */
namespace poinsot {

/** The parts of exp(θ), which is the unit quaternion (c, ½s·θ). */
struct HalfTurn {
  double c;  ///< cos(|θ|/2)
  double s;  ///< sin(|θ|/2) / (|θ|/2)
};

/** halfTurn() for |θ| ≥ 2, which is rare in steps. NaN where θ is not finite. */
HalfTurn wideHalfTurn(const Eigen::Vector3d& theta);

/**
 * Returns the parts of exp(θ) for any finite θ, also where |θ|² leaves the range of doubles.
 * Up to |θ| = 2 both are Taylor series in z = |θ|²/4, which have no 0/0 at 0 and are fast for short steps. Their terms
 * are summed in pairs, so that the processor need not wait for each in turn.
 */
inline HalfTurn halfTurn(const Eigen::Vector3d& theta) {
  const double z = 0.25 * (theta[0] * theta[0] + theta[1] * theta[1] + theta[2] * theta[2]);
  const double z2 = z * z, z4 = z2 * z2;
  // First terms left out, |θ| < 1/8: z⁵/10! and z⁵/11!, below 3e-19.
  if (z < 0.00390625) {
    return {(1 - z * (1.0 / 2)) + z2 * ((1.0 / 24 - z * (1.0 / 720)) + z2 * (1.0 / 40320)),
            (1 - z * (1.0 / 6)) + z2 * ((1.0 / 120 - z * (1.0 / 5040)) + z2 * (1.0 / 362880))};
  }
  // |θ| < 1/2: z⁷/14! and z⁷/15!, below 5e-20.
  if (z < 0.0625) {
    return {((1 - z * (1.0 / 2)) + z2 * (1.0 / 24 - z * (1.0 / 720))) +
                z4 * ((1.0 / 40320 - z * (1.0 / 3628800)) + z2 * (1.0 / 479001600)),
            ((1 - z * (1.0 / 6)) + z2 * (1.0 / 120 - z * (1.0 / 5040))) +
                z4 * ((1.0 / 362880 - z * (1.0 / 39916800)) + z2 * (1.0 / 6227020800))};
  }
  // |θ| < 2: z¹⁰/20! and z⁹/19!, below 1e-17. The 1 is added last, so that little is lost to rounding.
  if (z < 1) {
    const double z8 = z4 * z4;
    return {1 + ((z2 * (1.0 / 24 - z * (1.0 / 720)) - z * (1.0 / 2)) +
                 (z4 * ((1.0 / 40320 - z * (1.0 / 3628800)) + z2 * (1.0 / 479001600 - z * (1.0 / 87178291200))) +
                  z8 * (1.0 / 20922789888000 - z * (1.0 / 6402373705728000)))),
            1 + ((z2 * (1.0 / 120 - z * (1.0 / 5040)) - z * (1.0 / 6)) +
                 (z4 * ((1.0 / 362880 - z * (1.0 / 39916800)) + z2 * (1.0 / 6227020800 - z * (1.0 / 1307674368000))) +
                  z8 * (1.0 / 355687428096000)))};
  }
  return wideHalfTurn(theta);
}

/** Takes one Newton step towards |q| = 1, which is enough for a quaternion that is unit to about 1e-8. */
inline void renormalise(Quaternion& q) {
  q.coeffs() *= 1.5 - 0.5 * q.squaredNorm();
}

}  // namespace poinsot
