#pragma once

#include <cstdint>

#include "discriminant.h"
#include "elliptic.h"
#include "internal_axes.h"
#include "poinsot/core/closed_form_constants.h"
#include "series.h"

// Compiled once for each instruction set: see levels.h. Nothing here may be shared between them.
//
// All functions are templates on the type of number: DoubleDouble, or one with far more bits and an unlimited exponent.
namespace poinsot::closed_form::POINSOT_SIMD_LEVEL {

constexpr double kLargest = 0x1.fffffffffffffp1023;

/** Phases of more turns than this leave too few bits of a double-double below a turn. */
constexpr double kMostTurns = 0x1p44;

/** The two phases per unit of scaled time, in all their digits, and the half-period's phase at t = 0. */
template <class Real>
struct Rates {
  Real half, turn, half_start;
};

/** Products of quaternions w, x, y, z. */
template <class Real>
void multiply(const Real a[4], const Real b[4], Real out[4]) {
  out[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
  out[1] = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
  out[2] = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
  out[3] = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
}

template <class Real>
void normalisedAttitude(const Start& start, Real out[4]) {
  double largest = 0;
  for (const double x : start.attitude) largest = magnitude(x) > largest ? magnitude(x) : largest;
  const int e = exponentOf(largest);
  Real sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    out[i] = Number<Real>::exactly(start.attitude[i], -e);
    sum = sum + out[i] * out[i];
  }
  const Real inverse = Real(1.0) / sqrt(sum);
  for (int i = 0; i < 4; ++i) out[i] = out[i] * inverse;
}

/** Returns, exactly, whether Ω̇ = 0: rest, a sphere, a spin about a principal axis or across two equal moments. */
inline bool isSteady(const Start& s) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (!(s.moments[i] == s.moments[j] || s.omega[i] == 0 || s.omega[j] == 0)) return false;
  }
  return true;
}

/** A turn by |Ω|t about a fixed axis, in the form of the general motion with M along the third internal axis. */
template <class Real>
Rates<Real> setUpSteady(const Start& start, int omega_exponent, Constants& c) {
  Real w[3], sum = 0.0;
  int spins = 0;
  for (int i = 0; i < 3; ++i) {
    w[i] = Number<Real>::exactly(start.omega[i], -omega_exponent);
    sum = sum + w[i] * w[i];
    if (start.omega[i] != 0) {
      c.encircled = static_cast<std::int8_t>(i);
      ++spins;
    }
    c.from[i] = 2;
    c.omega[i] = start.omega[i];
  }
  if (spins != 1) c.encircled = -1;
  const Real rate = sqrt(sum);
  Real q0[4], axis[4] = {0.0, 0.0, 0.0, 0.0}, turned_q0[4];
  normalisedAttitude(start, q0);
  for (int i = 0; i < 3; ++i) axis[i + 1] = spins == 0 ? Real(0.0) : w[i] / rate;
  multiply(q0, axis, turned_q0);
  for (int i = 0; i < 4; ++i) {
    c.frame[i][0] = toDouble(q0[i]);
    c.frame[i][3] = toDouble(turned_q0[i]);
  }
  c.kind = Constants::Kind::steady;
  if (spins == 1) {
    const int axis_of_spin = c.encircled;
    const double own = start.moments[axis_of_spin], a = start.moments[(axis_of_spin + 1) % 3],
                 b = start.moments[(axis_of_spin + 2) % 3];
    if ((a < own && own < b) || (b < own && own < a)) c.complementary_modulus = 0;
  }
  return {Real(0.0), rate / (Number<Real>::pi() * 4.0), Real(0.0)};
}

/** θ functions and Z in y = cos 2α, nome q; e2 = exp(2η), η = πy/2K. Returns d(arg Z)/dα at α = 0. */
template <class Real>
Real trigonometricSeries(const Real& nome, const Real& e2, Constants& c) {
  const Real one = 1.0;
  const double q = toDouble(nome);
  const double q2 = q * q, q4 = q2 * q2, q6 = q4 * q2, q9 = q4 * q4 * q, q12 = q6 * q6, q16 = q12 * q4, q20 = q16 * q4;
  c.theta_even[0] = 1 - 2 * q4 + 2 * q16;
  c.theta_even[1] = 4 * q4 - 16 * q16;
  c.theta_even[2] = 16 * q16;
  c.theta_odd[0] = -2 * q + 6 * q9;
  c.theta_odd[1] = -8 * q9;
  c.sine_even[0] = 1 - q2 - q6 + q12 + q20;
  c.sine_even[1] = 4 * (q6 - q12) - 12 * q20;
  c.sine_even[2] = 16 * q20;
  c.sine_odd[0] = -2 * q2 + 2 * q6 + 4 * q12 - 4 * q20;
  c.sine_odd[1] = -8 * q12 + 8 * q20;

  // Z = 1 + 2 Σ (−1)ⁿ q^(2n²) cos 2n(α + iη)
  double even_part[4] = {1, 0, 0, 0}, odd_part[4] = {0, 0, 0, 0};
  Real at_zero = one, slope = 0.0;
  const Real q_squared = nome * nome, step = q_squared * q_squared;  // q^(2n²) grows by q^(4n+2)
  Real factor = q_squared, power = one, growth = e2, decay = one / e2;
  const Real fall = decay;
  for (int n = 1;; ++n) {
    power = power * factor;
    factor = factor * step;
    const Real cosh = power * (growth + decay), sinh = power * (growth - decay);  // twice, and times q^(2n²)
    const double sign = n % 2 ? -1 : 1;
    at_zero = at_zero + cosh * sign;
    slope = slope - sinh * (sign * 2 * n);
    if (n < 4) {
      even_part[n] = sign * toDouble(cosh);
      odd_part[n] = -sign * toDouble(sinh);
    }
    if (!(cosh > Number<Real>::powerOfTwo(-Number<Real>::kPrecision - 4))) break;
    growth = growth * e2;
    decay = decay * fall;
  }
  c.z_real[0] = 1 - even_part[2];
  c.z_real[1] = even_part[1] - 3 * even_part[3];
  c.z_real[2] = 2 * even_part[2];
  c.z_real[3] = 4 * even_part[3];
  c.z_imag[0] = odd_part[1] - odd_part[3];
  c.z_imag[1] = 2 * odd_part[2];
  c.z_imag[2] = 4 * odd_part[3];
  return slope / at_zero;
}

/** The same on the other side of Jacobi's imaginary transform, without the part that is linear in u. */
template <class Real>
Real hyperbolicSeries(const Real& nome, const Real& cos_half, const Real& sin_half, Constants& c) {
  const double q = toDouble(nome);
  double power = 1;
  for (double& x : c.nome) {
    x = power;
    power = power * q > 1e-150 ? power * q : 0;  // smaller ones are slow to compute with, and negligible beside 1
  }
  // cos and sin of (n + ½)η: each is the last one turned by η
  const Real cos_whole = cos_half * cos_half - sin_half * sin_half, sin_whole = scaled(cos_half * sin_half, 2);
  Real cosine = cos_half, sine = sin_half, weight = 1.0, factor = nome, sum = 0.0, slope = 0.0;
  for (int n = 0;; ++n) {
    if (n < 4) {
      c.z_cos[n] = toDouble(cosine);
      c.z_sin[n] = toDouble(sine);
    }
    sum = sum + weight * cosine;
    slope = slope + weight * sine * (n + 0.5);
    weight = weight * factor;
    factor = factor * nome;
    if (n >= 3 && !(weight > Number<Real>::powerOfTwo(-Number<Real>::kPrecision - 4))) break;
    const Real next = cosine * cos_whole - sine * sin_whole;
    sine = sine * cos_whole + cosine * sin_whole;
    cosine = next;
  }
  return slope / sum;
}

/** frame = (q₀ · conj(internal quaternion at t = 0)), then the permutation of axes. */
template <class Real>
void setFrame(const Start& start, const InternalAxes& axes, Constants& c) {
  for (int i = 0; i < 4; ++i) c.frame[i][i] = 1;
  const Evaluation first = evaluate(c, splitPhase(c.start.half), splitPhase(c.start.turn));
  Real q0[4], inverse[4], product[4], norm = 0.0;
  for (int i = 0; i < 4; ++i) norm = norm + Real(first.attitude[i]) * Real(first.attitude[i]);
  const Real factor = Real(1.0) / norm;
  inverse[0] = factor * first.attitude[0];
  for (int k = 0; k < 3; ++k) inverse[1 + axes.from[k]] = factor * (-axes.sign[k] * first.attitude[1 + k]);
  normalisedAttitude(start, q0);
  multiply(q0, inverse, product);
  double p[4];
  for (int i = 0; i < 4; ++i) p[i] = toDouble(product[i]);
  const double left[4][4] = {
      {p[0], -p[1], -p[2], -p[3]}, {p[1], p[0], -p[3], p[2]}, {p[2], p[3], p[0], -p[1]}, {p[3], -p[2], p[1], p[0]}};
  for (int i = 0; i < 4; ++i) {
    c.frame[i][0] = left[i][0];
    for (int k = 0; k < 3; ++k) c.frame[i][1 + k] = axes.sign[k] * left[i][1 + axes.from[k]];
  }
}

template <class Real>
Rates<Real> setUpMoving(const Start& start, int omega_exponent, int moment_exponent, Constants& c) {
  InternalAxes axes = ascending(start);
  const Discriminant<Real> d = discriminant<Real>(start, axes, moment_exponent);
  if (d.value < Real(0.0)) axes.swapFirstAndThird();
  if (axes.omega(start, 2) < 0) axes.halfTurnAbout(0);
  if (axes.omega(start, 0) < 0) axes.halfTurnAbout(2);

  Real I[3], M[3];
  for (int k = 0; k < 3; ++k) {
    I[k] = Number<Real>::exactly(axes.moment(start, k), -moment_exponent);
    M[k] = I[k] * Number<Real>::exactly(axes.omega(start, k), -omega_exponent);
  }
  const Real zero = 0.0, one = 1.0;
  const Real i21 = I[1] - I[0], i32 = I[2] - I[1], i31 = I[2] - I[0];
  const Real common = I[1] * i31;
  const Real r = I[0] * i32 / common, s = I[2] * i21 / common;
  const Real m2_squared = M[1] * M[1], m3_squared = M[2] * M[2];
  const Real a_squared = M[0] * M[0] + r * m2_squared, c_squared = m3_squared + s * m2_squared;
  const Real G = sqrt(M[0] * M[0] + m2_squared + m3_squared), A = sqrt(a_squared), B = sqrt(a_squared / r),
             C = sqrt(c_squared);
  // (I₃/(I₃−I₂)) D'/C²: after the swap both I₃ − I₂ and D' are negative.
  const Real k1_squared = I[2] * d.value / (i32 * c_squared);
  Real k1 = d.unscaled(sqrt(k1_squared), omega_exponent);
  if (k1 > one) k1 = one;
  const Real k_squared = s * a_squared / (r * c_squared);
  Real p = C / I[2] * sqrt(i31 * i32 / (I[0] * I[1]));
  if (i31 < zero) p = -p;
  const Real drift = a_squared / ((G + C) * I[0]) + C / I[2];  // ψ̇ at u = 0

  // cot² of the amplitude at the start; beyond 1/roundoff⁴ the angle counts as 0.
  const Real far = Number<Real>::powerOfTwo(2 * Number<Real>::kPrecision + 8);
  const bool begins_at_zero = M[1] == zero || !(abs(M[0]) < abs(M[1]) * far);
  const Real ratio = begins_at_zero ? one : M[0] / M[1];
  const Real square = begins_at_zero ? far : ratio * ratio / r < far ? ratio * ratio / r : far;
  const double side = axes.omega(start, 1) < 0 ? -1 : axes.omega(start, 1) > 0 ? 1 : 0;

  Rates<Real> rates;
  Real amplitude[3] = {A, B, C};  // of cn, sn, dn as the series give them
  double theta_ratio[3] = {1, 1, 1};
  Real phase_slope;  // d(arg Z)/du at u = 0
  c.kind = Constants::Kind::periodic;
  c.encircled = static_cast<std::int8_t>(axes.from[2]);
  c.symmetric = i21 == zero;
  const Real negligible = Number<Real>::powerOfTwo(-Number<Real>::kPrecision);
  if (k1 == zero) {
    c.kind = Constants::Kind::separatrix;
    c.encircled = -1;
    const Real tangent = one / sqrt(square);  // u₀ = asinh
    rates.half = p / kSeparatrixSpan;
    rates.half_start = square < far ? log(tangent + sqrt(tangent * tangent + one)) * side / kSeparatrixSpan : zero;
    c.span = c.span_high = kSeparatrixSpan;
    c.wraps = 0;
    c.series = Constants::Series::hyperbolic;
    const Landen<Real> across = landen<Real>(one, s / r);
    phase_slope = hyperbolicSeries(zero, across.cosHalf(), across.sinHalf(), c);
  } else {
    const Landen<Real> along = landen<Real>(k1, square);
    rates.half = p * along.mean / Number<Real>::pi();
    rates.half_start = along.angle * side / Number<Real>::pi();
    if (!(k_squared > negligible)) {
      phase_slope = zero;  // a circle: Z = 1
    } else {
      const Landen<Real> across = landen<Real>(sqrt(k_squared), s / r);
      const Real span = Number<Real>::pi() * across.mean / along.mean;
      if (span > Real(6.13)) {  // q > 0.2
        c.series = Constants::Series::hyperbolic;
        c.span = toDouble(span);
        constexpr double kToEightBits = 0x1p45;  // products with multiples of 2⁻⁴⁶ up to ½ are exact then
        c.span_high = (c.span + kToEightBits * c.span) - kToEightBits * c.span;
        c.span_rest = toDouble(span - Real(c.span_high));
        c.z_turn = toDouble(across.angle / Number<Real>::pi()) / 2;
        phase_slope = across.mean * hyperbolicSeries(exp(-span), across.cosHalf(), across.sinHalf(), c) -
                      across.angle * along.mean / Number<Real>::pi();
        c.root_nome = toDouble(exp(scaled(-span, 0.5)));
      } else {
        const Real inverse = along.mean / across.mean;
        phase_slope = along.mean * trigonometricSeries(exp(-Number<Real>::pi() * inverse),
                                                       exp(scaled(across.angle * inverse, 2)), c);
      }
    }
  }
  rates.turn = (drift + scaled(p * phase_slope, 2)) / (Number<Real>::pi() * 4.0);

  if (c.series == Constants::Series::hyperbolic) {
    const double* q = c.nome;
    const double theta2 = 2 * (1 + q[2] + q[6]);  // 2E·θ₂/2q'^¼ at x = 0
    const double theta3 = 1 + 2 * (q[1] + q[4]), theta4 = 1 - 2 * (q[1] - q[4]);
    theta_ratio[0] = theta2 / theta4 * ((1 - q[2]) * (1 - q[4]) * (1 - q[6]));
    theta_ratio[1] = theta3 / theta4;
    theta_ratio[2] = theta2 / theta3;
  } else {
    const double even = c.theta_even[0] + c.theta_even[1] + c.theta_even[2], odd = c.theta_odd[0] + c.theta_odd[1];
    const double theta4 = even + odd, theta3 = even - odd;
    const double theta2 = (c.sine_even[0] + c.sine_even[1] + c.sine_even[2]) - (c.sine_odd[0] + c.sine_odd[1]);
    theta_ratio[0] = theta4 / theta2;
    theta_ratio[1] = theta3 / theta2;
    theta_ratio[2] = theta4 / theta3;
  }
  for (int k = 0; k < 3; ++k) {
    c.momentum[k] = toDouble(amplitude[k] / G) * theta_ratio[k];
    c.from[axes.from[k]] = k;
  }
  // Amplitudes beyond the range of doubles are given in a larger unit, so that 0 times one is 0.
  for (int unit = 0; unit <= 1000; unit += 1000) {
    bool finite = true;
    for (int k = 0; k < 3; ++k) {
      double omega = toDouble(amplitude[k] / I[k], omega_exponent - unit) * theta_ratio[k];
      if (omega > kLargest) omega = kLargest, finite = false;
      c.omega[axes.from[k]] = axes.sign[k] * omega;
    }
    c.omega_unit = __builtin_ldexp(1.0, unit);
    if (finite) break;
  }
  c.complementary_modulus = toDouble(k1);
  c.delicate = magnitude(c.omega[axes.from[0]]) > 4 * magnitude(c.omega[axes.from[1]]);
  c.start.half = asPair(rates.half_start);
  setFrame<Real>(start, axes, c);
  return rates;
}

template <class Real>
Rates<Real> setUp(const Start& start, Constants& c) {
  double omega = 0, moment = 0;
  for (int i = 0; i < 3; ++i) {
    omega = magnitude(start.omega[i]) > omega ? magnitude(start.omega[i]) : omega;
    moment = start.moments[i] > moment ? start.moments[i] : moment;
  }
  // Bounded so that 2^e stays in the range of doubles; the scaled Ω may then be far from 1.
  constexpr int kMostExponent = 1000;
  int omega_exponent = omega == 0 ? 0 : exponentOf(omega);
  if (omega_exponent > kMostExponent) omega_exponent = kMostExponent;
  if (omega_exponent < -kMostExponent) omega_exponent = -kMostExponent;
  const int moment_exponent = exponentOf(moment);
  c.time_scale = __builtin_ldexp(1.0, omega_exponent);
  const Rates<Real> rates = isSteady(start) ? setUpSteady<Real>(start, omega_exponent, c)
                                            : setUpMoving<Real>(start, omega_exponent, moment_exponent, c);
  c.rate.half = asPair(rates.half);
  c.rate.turn = asPair(rates.turn);
  const double half = c.kind == Constants::Kind::separatrix ? 0 : magnitude(c.rate.half.high);
  const double turn = magnitude(c.rate.turn.high);
  c.reach = kMostTurns / (half > turn ? half : turn);
  return rates;
}

}  // namespace poinsot::closed_form::POINSOT_SIMD_LEVEL
