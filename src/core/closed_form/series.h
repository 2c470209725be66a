#pragma once

#include "elementary.h"
#include "poinsot/core/closed_form_constants.h"
#include "poinsot/core/pi.h"

// Compiled once for each instruction set: see levels.h. Nothing here may be shared between them.
namespace poinsot::closed_form::POINSOT_SIMD_LEVEL {

/** Below this nome the hyperbolic series need fewer terms. */
constexpr double kShortNome = 3e-5;

/** Added to numbers whose powers are added to 1: it keeps powers from underflowing, which would be slow. */
constexpr double kSmallest = 1e-40;

/** Attitude w, x, y, z; and along the internal axes Ω over its amplitudes: cn, sn, dn. */
struct Evaluation {
  double attitude[4], omega[3];
};

/**
 * A phase in two parts. The series take any with |rest| far below 1; where `grid` is a multiple of 2⁻⁴⁶, sums and small
 * multiples of it are exact while below 128.
 */
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
  const double er = mulAdd(f.cos, z_real, f.sin * z_imag);
  const double ei = mulAdd(f.sin, z_real, -(f.cos * z_imag));
  const double square = mulAdd(er, er, ei * ei) * mulAdd(w, w, mulAdd(m1, m1, m2 * m2));
  const double norm = __builtin_sqrt(square);
  const double inverse = 1.0 / (norm * denominator);
  const double a = inverse * denominator, b = inverse * norm;
  const double v0 = er * w, v1 = mulAdd(er, m2, ei * m1), v2 = mulAdd(ei, m2, -(er * m1)), v3 = ei * w;
  Evaluation out;
  for (int i = 0; i < 4; ++i) {
    out.attitude[i] =
        a * (mulAdd(c.frame[i][0], v0, c.frame[i][1] * v1) + mulAdd(c.frame[i][2], v2, c.frame[i][3] * v3));
  }
  out.omega[0] = b * cn;
  out.omega[1] = b * sn;
  out.omega[2] = b * dn;
  return out;
}

/** Returns cos and sin of 2π(f + g), g small. */
POINSOT_INLINE SinCos turnBy(SplitPhase f, double g) {
  const double quarters = nearest(4.0 * (f.grid + g));
  return turned(sinCosSmall(2.0 * kPi * ((mulAdd(-0.25, quarters, f.grid) + g) + f.rest)), quarters);
}

/** Returns cos and sin of α = πv, each to its last bits also near its zeros. */
POINSOT_INLINE SinCos amplitude(SplitPhase v) {
  const double quarters = nearest(2.0 * v.grid);
  return turned(sinCosSmall(kPi * (mulAdd(-0.5, quarters, v.grid) + v.rest)), quarters);
}

/** θ functions and Z as polynomials in y = cos 2α. @param turn e^{2πif} */
POINSOT_INLINE Evaluation trigonometric(const Constants& c, SinCos alpha, SinCos turn) {
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

/** The place on the hyperbolic side: v less its nearest whole number n. */
struct HyperbolicPlace {
  double grid, rest;  ///< d = v − n, |d| ≤ ½
  double d, side;     ///< their sum and its sign
  double parity;      ///< (−1)ⁿ
};

POINSOT_INLINE HyperbolicPlace hyperbolicPlace(const Constants& c, SplitPhase v) {
  const double n = c.wraps * nearest(v.grid);
  double grid = v.grid - n;
  grid = grid < 0.5 ? grid : 0.5;
  grid = grid > -0.5 ? grid : -0.5;
  const double d = grid + v.rest;
  return {grid, v.rest, d, d < 0 ? -1.0 : 1.0, mulAdd(-2.0, mulAdd(-2.0, nearest(0.5 * n - 0.25), n), 1.0)};
}

/** E = e^{−|x|} and H = √q' e^{|x|}, x = Xd, both ≤ 1; and 1 less each. All to their last bits. */
struct Decays {
  double E, E_complement, H, H_complement;
};

POINSOT_INLINE Decays decays(const Constants& c, const HyperbolicPlace& v) {
  // The larger of the two has the smaller exponent; the other is √q' over it.
  const bool inner = v.side * v.d < 0.25;
  const double way = inner ? v.side * v.grid : 0.5 - v.side * v.grid;
  // The exponent has two parts, because with a tiny moment Ω may be large where E is small, and rounding errors of x
  // are multiplied by x.
  const SplitPhase split = splitPhase({way, inner ? v.side * v.rest : -(v.side * v.rest)});
  const Exponentials e = exponentials(c.span_high * split.grid, mulAdd(c.span_rest, split.grid, c.span * split.rest));
  const double other = c.root_nome * e.growth;
  return {inner ? e.decay : other, inner ? e.complement : 1.0 - other, inner ? other : e.decay,
          inner ? 1.0 - other : e.complement};
}

/**
 * Jacobi's imaginary transform: θ functions and Z from E and H.
 * @param kShort leave out the terms that are below roundoff for q' < kShortNome
 * @param turn e^{2πif + iηd}, with the part of arg Z that is linear in d
 */
template <bool kShort>
POINSOT_INLINE Evaluation hyperbolic(const Constants& c, const Decays& decays, double side, double parity,
                                     SinCos turn) {
  const double E = decays.E, H = decays.H;
  const double F = E + kSmallest, K = H + kSmallest;
  const double E2 = F * F, H2 = K * K, E4 = E2 * E2, H4 = H2 * H2;
  const double* q = c.nome;
  const double E_factor = decays.E_complement * (1.0 + E), H_factor = decays.H_complement * (1.0 + H);
  // 2E·(cosh x, sinh x, θ₄(ix), θ₃(ix)) and their companions
  double t2 = mulAdd(q[1], H2, mulAdd(q[2], E4, 1.0 + E2));
  double t1 = mulAdd(-q[1], H2, mulAdd(q[2], E4, E_factor));
  double t4 = mulAdd(-q[1], E2, 1.0) * mulAdd(-q[2], H2, mulAdd(-q[3], E2, 1.0));
  double t3 = mulAdd(q[1], E2, mulAdd(q[2], H4, 1.0 + H2));
  double z_real = mulAdd(c.z_cos[1], mulAdd(c.root_nome, H, q[1] * E2), mulAdd(c.z_cos[0], E, c.z_cos[0]));
  double z_imag = mulAdd(c.z_sin[1], mulAdd(c.root_nome, H, -(q[1] * E2)), c.z_sin[0] * decays.E_complement);
  const double E3 = E2 * F;
  z_real = mulAdd(c.z_cos[2] * q[2], H2, mulAdd(c.z_cos[2] * q[3], E3, z_real));
  z_imag = mulAdd(c.z_sin[2] * q[2], H2, mulAdd(-c.z_sin[2] * q[3], E3, z_imag));
  if (!kShort) {
    t2 += mulAdd(q[4], H4, q[6] * (E4 * E2));
    t1 += mulAdd(q[4], H4, -(q[6] * (E4 * E2)));
    t4 = mulAdd(t4, mulAdd(-q[5], E2, -(q[4] + q[6]) * H2), t4);
    t3 += mulAdd(q[4], E4, q[6] * (H4 * H2));
    z_real = mulAdd(c.z_cos[3], mulAdd(c.root_nome * q[4], H2 * K, q[6] * E4), z_real);
    z_imag = mulAdd(c.z_sin[3], mulAdd(c.root_nome * q[4], H2 * K, -(q[6] * E4)), z_imag);
  }
  return assemble(c, parity * (E * H_factor * t4), (parity * side) * t1, E * t3, t2, z_real, side * z_imag, turn);
}

POINSOT_INLINE Evaluation evaluate(const Constants& c, SplitPhase half, SplitPhase turn) {
  if (c.series == Constants::Series::trigonometric) return trigonometric(c, amplitude(half), turnBy(turn, 0.0));
  const HyperbolicPlace place = hyperbolicPlace(c, half);
  return hyperbolic<false>(c, decays(c, place), place.side, place.parity, turnBy(turn, c.z_turn * place.d));
}

}  // namespace poinsot::closed_form::POINSOT_SIMD_LEVEL
