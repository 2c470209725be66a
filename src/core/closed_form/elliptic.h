#pragma once

#include "double_double.h"

// Compiled once for each instruction set: see levels.h. Nothing here may be shared between them.
namespace poinsot::closed_form::POINSOT_SIMD_LEVEL {

/** The arithmetic-geometric mean of 1 and b, and the amplitude to which Landen's transformation converges. */
template <class Real>
struct Landen {
  Real mean;       ///< a∞ = agm(1, b); the complete integral with complementary modulus b is K = π/2a∞
  Real cotangent;  ///< of the angle, times a∞
  Real angle;      ///< a∞·F, so that F/K = angle/(π/2)

  Real cosHalf() const { return sqrt(scaled(cotangent / hypotenuse() + 1.0, 0.5)); }
  Real sinHalf() const { return scaled(mean / hypotenuse() / cosHalf(), 0.5); }

 private:
  Real hypotenuse() const { return sqrt(mean * mean + cotangent * cotangent); }
};

/**
 * Returns Legendre's first integral F(φ), tan φ = 1/√square, with complementary modulus 0 < b ≤ 1, by the ascending
 * transformation of cot²φ: with w = √((c² + a²)(c² + b²)),
 *   c² ← ½(c² − ab + w)  or, what is the same,  ½c²(a + b)²/(w + ab − c²),  whichever does not cancel.
 * It needs no count of quadrants and loses no digits for φ near 0 or π/2 or for b near 0 (Carlson 1965; Bulirsch 1965).
 * @param square cot²φ ≥ 0; larger values may be replaced by one for which 1/square² is below the precision.
 */
template <class Real>
Landen<Real> landen(Real b, Real square) {
  Real a = 1.0;
  // The transformation converges quadratically: from |a − b| = 2^(−p/2) a, the next difference is below the precision.
  const Real enough = Number<Real>::powerOfTwo(-Number<Real>::kPrecision / 2 - 2);
  for (bool last = false; !last;) {
    last = !(abs(a - b) > enough * a);
    const Real product = a * b;
    const Real w = sqrt((square + a * a) * (square + b * b));
    if (square < product) {
      const Real sum = a + b;
      square = scaled(square * (sum * sum) / (w + (product - square)), 0.5);
    } else {
      square = scaled(w + (square - product), 0.5);
    }
    a = scaled(a + b, 0.5);
    b = sqrt(product);
  }
  const Real cotangent = sqrt(square);
  return {a, cotangent, atan2(a, cotangent)};
}

}  // namespace poinsot::closed_form::POINSOT_SIMD_LEVEL
