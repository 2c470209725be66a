#pragma once

#include <cstdint>

// Compiled once for each instruction set: see levels.h. Nothing here may be shared between them.
//
// Written without branches and library calls, so that a loop over it becomes vector code.
namespace poinsot::closed_form::POINSOT_SIMD_LEVEL {

#define POINSOT_INLINE inline __attribute__((always_inline))

template <class To, class From>
POINSOT_INLINE To bitsOf(From from) {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

/** Returns the nearest integer, for |x| < 2⁵¹. */
POINSOT_INLINE double nearest(double x) {
  constexpr double kShift = 0x1.8p52;
  return (x + kShift) - kShift;
}

struct SinCos {
  double sin, cos;
};

/** Returns a·b + c, with one rounding and in one instruction where the processor has that. */
POINSOT_INLINE double mulAdd(double a, double b, double c) {
#ifdef POINSOT_FMA
  return __builtin_fma(a, b, c);
#else
  return a * b + c;
#endif
}

/** Returns c₀ + c₁x + c₂x² + … */
POINSOT_INLINE double polynomial(double, double c0) {
  return c0;
}
template <class... Rest>
POINSOT_INLINE double polynomial(double x, double c0, Rest... rest) {
  return mulAdd(x, polynomial(x, rest...), c0);
}

/**
 * Returns sin and cos for |x| ≤ π/4 + 0.01, to 2⁻⁵⁸ but for rounding: the minimax coefficients of Sun's fdlibm
 * (k_sin.c, k_cos.c).
 */
POINSOT_INLINE SinCos sinCosSmall(double x) {
  const double z = x * x;
  const double s = polynomial(z, -1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04,
                              2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10);
  const double c = polynomial(z, 4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05,
                              -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11);
  const double half = 0.5 * z, w = 1.0 - half;
  return {mulAdd(x, z * s, x), w + mulAdd(z * z, c, (1.0 - w) - half)};
}

/** Turns (sin, cos) by `quarters` quarter turns. */
POINSOT_INLINE SinCos turned(SinCos a, double quarters) {
  const double halves = nearest(0.5 * quarters - 0.25);
  const double odd = quarters - 2.0 * halves;  // 0 or 1
  const double sign = 1.0 - 2.0 * (halves - 2.0 * nearest(0.5 * halves - 0.25));
  return {sign * (odd > 0.5 ? a.cos : a.sin), sign * (odd > 0.5 ? -a.sin : a.cos)};
}

/** Returns the product of the complex numbers cos + i sin. */
POINSOT_INLINE SinCos operator*(SinCos a, SinCos b) {
  return {mulAdd(a.sin, b.cos, a.cos * b.sin), mulAdd(a.cos, b.cos, -(a.sin * b.sin))};
}

struct Exponentials {
  double decay, complement, growth;  ///< e⁻ᵃ, 1 − e⁻ᵃ, eᵃ, each to its last bits
};

/** Returns those of a + rest ≥ −0.3, |rest| ≤ a/100; beyond 600 those near 600. */
POINSOT_INLINE Exponentials exponentials(double a, double rest) {
  constexpr double kInverseLn2 = 0x1.71547652b82fep+0;
  constexpr double kLn2High = 0x1.62e42fee00000p-1, kLn2Low = 0x1.a39ef35793c76p-33;  // high: 32 bits
  a = a < 600.0 ? a : 600.0;
  const double n = nearest((a + rest) * kInverseLn2);
  const double r = mulAdd(n, -kLn2Low, mulAdd(n, -kLn2High, a)) + rest;
  // sinh r and cosh r − 1 for |r| ≤ ½ ln 2 by Taylor; the first terms left out are below 5e-18.
  const double z = r * r;
  const double sinh =
      mulAdd(r * z, polynomial(z, 1.0 / 6, 1.0 / 120, 1.0 / 5040, 1.0 / 362880, 1.0 / 39916800, 1.0 / 6227020800), r);
  const double cosh = z * polynomial(z, 0.5, 1.0 / 24, 1.0 / 720, 1.0 / 40320, 1.0 / 3628800, 1.0 / 479001600);
  const double less = cosh - sinh, more = cosh + sinh;
  // The low bits of these are the exponents of 2⁻ⁿ and 2ⁿ.
  const double down = (1023.0 - n) + 0x1.8p52, up = (1023.0 + n) + 0x1.8p52;
  const double shrink = bitsOf<double>(bitsOf<std::uint64_t>(down) << 52);
  const double grow = bitsOf<double>(bitsOf<std::uint64_t>(up) << 52);
  return {mulAdd(shrink, less, shrink), mulAdd(-shrink, less, 1.0 - shrink), mulAdd(grow, more, grow)};
}

}  // namespace poinsot::closed_form::POINSOT_SIMD_LEVEL
