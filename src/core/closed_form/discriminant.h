#pragma once

#include "double_double.h"
#include "internal_axes.h"

// Compiled once for each instruction set: see levels.h. Nothing here may be shared between them.
namespace poinsot::closed_form {

/** a²bΔ − c²dδ with Δ = e − f, δ = g − h, to all bits of a Pair whatever cancels; with exact sign. Slow. */
Pair exactDiscriminant(double w3, double i3, double i2, double i1, double w1);

namespace POINSOT_SIMD_LEVEL {

/**
 * D' = Ω₃²I₃(I₃−I₂) − Ω₁²I₁(I₂−I₁) for ascending moments: its sign says which axis the polhode goes round, its size how
 * far the separatrix is. It is the only ill-conditioned part of the problem, hence exact products and an exact sum.
 */
template <class Real>
struct Discriminant {
  Real value;  ///< with moments and Ω scaled: Ω₁, Ω₃ by 2^−exponent
  int exponent = 0;

  /** From the root of a quantity in `value`'s scale to one in which Ω is scaled by 2^−omega_exponent. */
  Real unscaled(const Real& root, int omega_exponent) const {
    return root * Number<Real>::powerOfTwo(exponent - omega_exponent);
  }
};

inline double magnitude(double x) {
  return x < 0 ? -x : x;
}

/** Returns e such that x = m·2^e, ½ ≤ m < 1. */
inline int exponentOf(double x) {
  int e = 0;
  (void)__builtin_frexp(x, &e);
  return e;
}

/** Returns the sum of n doubles, as good as if added up in four times their precision (Ogita, Rump and Oishi 2005). */
inline DoubleDouble exactSumOf(double* terms, int n) {
  for (int pass = 0; pass < 3; ++pass) {
    for (int i = 1; i < n; ++i) {
      const DoubleDouble s = exactSum(terms[i], terms[i - 1]);
      terms[i] = s.high;
      terms[i - 1] = s.low;
    }
  }
  DoubleDouble sum = 0.0;
  for (int i = 0; i < n; ++i) sum = sum + terms[i];
  return sum;
}

/** Appends w²·i·(j − k)·sign exactly, as at most 16 doubles, without zeros. */
inline double* appendTerms(double w, double i, double j, double k, double sign, double* out) {
  const DoubleDouble square = exactProduct(w, w), difference = exactSum(j, -k);
  const DoubleDouble a = exactProduct(i, difference.high), b = exactProduct(i, difference.low);
  const double x[] = {a.high, a.low, b.high, b.low}, y[] = {square.high, square.low};
  for (int n = 0; n < 8; ++n) {
    if (x[n / 2] == 0 || y[n % 2] == 0) continue;
    const DoubleDouble p = exactProduct(sign * x[n / 2], y[n % 2]);
    *out++ = p.high;
    if (p.low != 0) *out++ = p.low;
  }
  return out;
}

/** Returns the exponent of the larger of Ω₁ and Ω₃. */
inline int outerExponent(const Start& start, const InternalAxes& axes) {
  const double w1 = magnitude(axes.omega(start, 0)), w3 = magnitude(axes.omega(start, 2));
  return exponentOf(w1 > w3 ? w1 : w3);
}

template <class Real>
Discriminant<Real> discriminant(const Start& start, const InternalAxes& axes, int moment_exponent) {
  const int e = outerExponent(start, axes);
  Real I[3];
  for (int k = 0; k < 3; ++k) I[k] = Number<Real>::exactly(axes.moment(start, k), -moment_exponent);
  const Real w1 = Number<Real>::exactly(axes.omega(start, 0), -e), w3 = Number<Real>::exactly(axes.omega(start, 2), -e);
  return {w3 * w3 * (I[2] * (I[2] - I[1])) - w1 * w1 * (I[0] * (I[1] - I[0])), e};
}

template <>
inline Discriminant<DoubleDouble> discriminant<DoubleDouble>(const Start& start, const InternalAxes& axes,
                                                             int moment_exponent) {
  const int e = outerExponent(start, axes);
  double I[3];
  for (int k = 0; k < 3; ++k) I[k] = __builtin_ldexp(axes.moment(start, k), -moment_exponent);
  const double w1 = __builtin_ldexp(axes.omega(start, 0), -e), w3 = __builtin_ldexp(axes.omega(start, 2), -e);
  const DoubleDouble third = exactProduct(w3, w3) * ((DoubleDouble(I[2]) - I[1]) * I[2]);
  const DoubleDouble first = exactProduct(w1, w1) * ((DoubleDouble(I[1]) - I[0]) * I[0]);
  const DoubleDouble rough = third - first;
  if (magnitude(rough.high) > 0.125 * (third.high + first.high)) return {rough, e};
  double terms[32];
  double* end = appendTerms(w3, I[2], I[2], I[1], 1, terms);
  end = appendTerms(w1, I[0], I[1], I[0], -1, end);
  const DoubleDouble sum = exactSumOf(terms, static_cast<int>(end - terms));
  // The error of the sum is below 2⁻²⁰⁰ of the terms.
  if (magnitude(sum.high) > 0x1p-90 * third.high) return {sum, e};
  const Pair exact = exactDiscriminant(w3, I[2], I[1], I[0], w1);
  return {{exact.high, exact.low}, e};
}

}  // namespace POINSOT_SIMD_LEVEL
}  // namespace poinsot::closed_form
