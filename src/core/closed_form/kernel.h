#pragma once

#include <cstdint>

#include "poinsot/core/closed_form_constants.h"

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

/** The nearest integer, for |x| < 2⁵¹. */
POINSOT_INLINE double nearest(double x) {
  constexpr double kShift = 0x1.8p52;
  return (x + kShift) - kShift;
}

struct SinCos {
  double sin, cos;
};

/** a·b + c: one rounding and one instruction where the processor has it. */
POINSOT_INLINE double mulAdd(double a, double b, double c) {
#ifdef __FP_FAST_FMA
  return __builtin_fma(a, b, c);
#else
  return a * b + c;
#endif
}

/** c₀ + c₁x + c₂x² + … */
POINSOT_INLINE double polynomial(double, double c0) {
  return c0;
}
template <class... Rest>
POINSOT_INLINE double polynomial(double x, double c0, Rest... rest) {
  return mulAdd(x, polynomial(x, rest...), c0);
}

/** sin and cos for |x| ≤ 0.8: Taylor series; the first terms left out are below 1e-18. */
POINSOT_INLINE SinCos sinCosSmall(double x) {
  const double z = x * x;
  const double s = polynomial(z, -1.0 / 6, 1.0 / 120, -1.0 / 5040, 1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800,
                              -1.0 / 1307674368000, 1.0 / 355687428096000);
  const double c = polynomial(z, 1.0 / 24, -1.0 / 720, 1.0 / 40320, -1.0 / 3628800, 1.0 / 479001600, -1.0 / 87178291200,
                              1.0 / 20922789888000);
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

struct Decay {
  double value, complement;  ///< e⁻ᵃ and 1 − e⁻ᵃ, each to its last bits
};

/** e⁻ᵃ for a ≥ −0.3; e⁻⁷⁰⁰ beyond 700. */
POINSOT_INLINE Decay decay(double a) {
  constexpr double kInverseLn2 = 0x1.71547652b82fep+0;
  constexpr double kLn2High = 0x1.62e42fee00000p-1, kLn2Low = 0x1.a39ef35793c76p-33;  // high: 32 bits
  a = a < 700.0 ? a : 700.0;
  const double n = nearest(a * kInverseLn2);
  const double r = mulAdd(n, kLn2Low, mulAdd(n, kLn2High, -a));
  // eʳ − 1, |r| ≤ ½ ln 2, by Taylor; the first term left out is below 4e-18.
  const double tail = polynomial(r, 0.5, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 720, 1.0 / 5040, 1.0 / 40320, 1.0 / 362880,
                                 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800);
  const double p = mulAdd(r * r, tail, r);
  const double shifted = (1023.0 - n) + 0x1.8p52;  // its low bits are the exponent of 2⁻ⁿ
  const double scale = bitsOf<double>(bitsOf<std::int64_t>(shifted) << 52);
  return {mulAdd(scale, p, scale), mulAdd(-scale, p, 1.0 - scale)};
}

constexpr double kPi = 3.141592653589793238462643;

/** Attitude w, x, y, z; and along the internal axes Ω over its amplitudes: cn, sn, dn. */
struct Evaluation {
  double attitude[4], omega[3];
};

/** A phase as a multiple of 2⁻⁴⁶ and the rest: sums and small multiples of the first are exact while below 128. */
struct SplitPhase {
  double grid, rest;
};

/** @param phase below 32 in size. */
POINSOT_INLINE SplitPhase splitPhase(Pair phase) {
  constexpr double kShift = 0x1.8p6;  // so that the last bit of the sum is 2⁻⁴⁶
  const double grid = (phase.high + kShift) - kShift;
  return {grid, (phase.high - grid) + phase.low};
}

/**
 * The state from cn, sn, dn, given times a common positive denominator, and from Z up to a positive factor:
 *   q = frame·(cos ½ψ, 0, 0, sin ½ψ)·P(M),  e^{iψ/2} = e^{2πif}·conj(Z)/|Z|,  P = ½(1 + M₃, M₂, −M₁, 0)/p₀,
 * M in units of |L|. p₀ is never formed: one square root and one division serve q and Ω.
 */
POINSOT_INLINE Evaluation assemble(const Constants& c, double cn, double sn, double dn, double denominator,
                                   double z_real, double z_imag, SinCos f) {
  const double m1 = c.momentum[0] * cn, m2 = c.momentum[1] * sn, m3 = c.momentum[2] * dn;
  const double w = denominator + m3;
  const double er = f.cos * z_real + f.sin * z_imag;
  const double ei = f.sin * z_real - f.cos * z_imag;
  const double norm = __builtin_sqrt((er * er + ei * ei) * (w * w + (m1 * m1 + m2 * m2)));
  const double inverse = 1.0 / (norm * denominator);
  const double a = inverse * denominator, b = inverse * norm;
  const double v0 = a * (er * w), v1 = a * (er * m2 + ei * m1), v2 = a * (ei * m2 - er * m1), v3 = a * (ei * w);
  Evaluation out;
  for (int i = 0; i < 4; ++i) {
    out.attitude[i] = mulAdd(c.frame[i][0], v0, c.frame[i][1] * v1) + mulAdd(c.frame[i][2], v2, c.frame[i][3] * v3);
  }
  out.omega[0] = b * cn;
  out.omega[1] = b * sn;
  out.omega[2] = b * dn;
  return out;
}

/** α = πv; θ functions as polynomials in y = cos 2α. */
POINSOT_INLINE Evaluation trigonometric(const Constants& c, SplitPhase v, SplitPhase f) {
  const double quarters = nearest(2.0 * v.grid);
  const SinCos alpha = turned(sinCosSmall(kPi * ((v.grid - 0.5 * quarters) + v.rest)), quarters);
  const double f_quarters = nearest(4.0 * f.grid);
  const SinCos turn = turned(sinCosSmall(2.0 * kPi * ((f.grid - 0.25 * f_quarters) + f.rest)), f_quarters);

  const double y = (alpha.cos - alpha.sin) * (alpha.cos + alpha.sin);
  const double y2 = y * y;
  const double even = polynomial(y2, c.theta_even[0], c.theta_even[1], c.theta_even[2]);
  const double odd = y * polynomial(y2, c.theta_odd[0], c.theta_odd[1]);
  const double sine_even = polynomial(y2, c.sine_even[0], c.sine_even[1], c.sine_even[2]);
  const double sine_odd = y * polynomial(y2, c.sine_odd[0], c.sine_odd[1]);
  const double z_real = polynomial(y, c.z_real[0], c.z_real[1], c.z_real[2], c.z_real[3]);
  const double z_imag = 2.0 * alpha.sin * alpha.cos * polynomial(y, c.z_imag[0], c.z_imag[1], c.z_imag[2]);
  return assemble(c, alpha.cos * (sine_even - sine_odd), alpha.sin * (sine_even + sine_odd), even - odd, even + odd,
                  z_real, z_imag, turn);
}

/** Jacobi's imaginary transform: the same functions from E = e^{−|x|} and H = √q' e^{|x|}, both ≤ 1. */
POINSOT_INLINE Evaluation hyperbolic(const Constants& c, SplitPhase v, SplitPhase f) {
  double n = nearest(v.grid);
  const bool wraps = c.kind == Constants::Kind::periodic;
  n = wraps ? n : 0.0;
  double grid = v.grid - n, rest = v.rest;
  grid = grid < 0.5 ? grid : 0.5;
  grid = grid > -0.5 ? grid : -0.5;
  const double d = grid + rest;
  const double side = d < 0 ? -1.0 : 1.0;
  const double parity = 1.0 - 2.0 * (n - 2.0 * nearest(0.5 * n - 0.25));

  const double g = c.z_turn * d;
  const double f_quarters = nearest(4.0 * (f.grid + g));
  const SinCos turn = turned(sinCosSmall(2.0 * kPi * (((f.grid - 0.25 * f_quarters) + g) + f.rest)), f_quarters);

  const Decay e = decay(c.span * (side * d));
  const Decay h = decay(c.span * ((0.5 - side * grid) - side * rest));
  const double E = e.value, H = h.value;
  const double E2 = E * E, H2 = H * H, E4 = E2 * E2, H4 = H2 * H2;
  const double* q = c.nome;
  const double t2 = (1.0 + E2) + (q[1] * H2 + q[2] * E4 + (q[4] * H4 + q[6] * (E4 * E2)));
  const double t1 = e.complement * (1.0 + E) - (q[1] * H2 - q[2] * E4 - (q[4] * H4 - q[6] * (E4 * E2)));
  const double t4 = (E * (h.complement * (1.0 + H))) * ((1.0 - q[1] * E2) * (1.0 - q[2] * H2)) *
                    ((1.0 - q[3] * E2) * (1.0 - (q[4] + q[6]) * H2 - q[5] * E2));
  const double t3 = E * ((1.0 + H2) + (q[1] * E2 + q[2] * H4 + (q[4] * E4 + q[6] * (H4 * H2))));
  const double z_real =
      c.z_cos[0] * (1.0 + E) + c.z_cos[1] * (c.root_nome * H + q[1] * E2) +
      (c.z_cos[2] * (q[2] * H2 + q[3] * (E2 * E)) + c.z_cos[3] * (c.root_nome * q[4] * (H2 * H) + q[6] * E4));
  const double z_imag =
      c.z_sin[0] * e.complement + c.z_sin[1] * (c.root_nome * H - q[1] * E2) +
      (c.z_sin[2] * (q[2] * H2 - q[3] * (E2 * E)) + c.z_sin[3] * (c.root_nome * q[4] * (H2 * H) - q[6] * E4));
  return assemble(c, parity * t4, (parity * side) * t1, t3, t2, z_real, side * z_imag, turn);
}

POINSOT_INLINE Evaluation evaluate(const Constants& c, SplitPhase half, SplitPhase turn) {
  return c.series == Constants::Series::hyperbolic ? hyperbolic(c, half, turn) : trigonometric(c, half, turn);
}

}  // namespace poinsot::closed_form::POINSOT_SIMD_LEVEL
