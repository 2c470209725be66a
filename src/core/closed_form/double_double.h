#pragma once

#include "poinsot/core/closed_form_constants.h"

// Defined where the processor multiplies and adds in one instruction. clang defines only the second name on x86-64.
#if defined(__FP_FAST_FMA) || defined(__FMA__)
#define POINSOT_FMA
#endif

// Compiled once for each instruction set: see levels.h. Nothing here may be shared between them.
namespace poinsot::closed_form::POINSOT_SIMD_LEVEL {

/**
 * A number as the unevaluated sum of two doubles, |low| ≤ half an ulp of high: about 106 bits (Dekker 1971; the
 * algorithms are those of Hida, Li and Bailey, "Library for double-double and quad-double arithmetic", 2007).
 * Needs IEEE arithmetic as written: no -ffast-math. Relative errors are a few 2⁻¹⁰⁴; nothing guards against overflow
 * beyond 1e290 or against low parts below 1e-308.
 */
struct DoubleDouble {
  double high = 0, low = 0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double value) : high(value) {}  // NOLINT: meant to convert
  constexpr DoubleDouble(double h, double l) : high(h), low(l) {}
};

/** a + b exactly. */
inline DoubleDouble exactSum(double a, double b) {
  const double sum = a + b;
  const double taken = sum - a;
  return {sum, (a - (sum - taken)) + (b - taken)};
}

/** a + b exactly, for |a| ≥ |b| or a = 0. */
inline DoubleDouble exactSumOrdered(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/** a·b exactly. */
inline DoubleDouble exactProduct(double a, double b) {
  const double product = a * b;
#ifdef POINSOT_FMA
  return {product, __builtin_fma(a, b, -product)};
#else
  constexpr double kSplitter = 134217729.0;  // 2²⁷ + 1
  const double ta = kSplitter * a, tb = kSplitter * b;
  const double a1 = ta - (ta - a), b1 = tb - (tb - b);
  const double a2 = a - a1, b2 = b - b1;
  return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
#endif
}

inline DoubleDouble operator-(const DoubleDouble& a) {
  return {-a.high, -a.low};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble s = exactSum(a.high, b.high);
  const DoubleDouble t = exactSum(a.low, b.low);
  const DoubleDouble u = exactSumOrdered(s.high, s.low + t.high);
  return exactSumOrdered(u.high, u.low + t.low);
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + -b;
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble p = exactProduct(a.high, b.high);
  return exactSumOrdered(p.high, p.low + (a.high * b.low + a.low * b.high));
}

inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double quotient = a.high / b.high;
  const DoubleDouble p = exactProduct(quotient, b.high);
  const double rest = ((a.high - p.high) - p.low) + (a.low - quotient * b.low);  // the first difference is exact
  return exactSumOrdered(quotient, rest / b.high);
}

inline bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}
inline bool operator>(const DoubleDouble& a, const DoubleDouble& b) {
  return b < a;
}
inline bool operator==(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high == b.high && a.low == b.low;
}

inline DoubleDouble sqrt(const DoubleDouble& a) {
  if (!(a.high > 0)) return 0.0;
  const double root = __builtin_sqrt(a.high);
  const DoubleDouble rest = a - exactProduct(root, root);
  return exactSumOrdered(root, rest.high / (2 * root));
}

inline DoubleDouble abs(const DoubleDouble& a) {
  return a.high < 0 ? -a : a;
}

/** Returns a times a power of two. */
inline DoubleDouble scaled(const DoubleDouble& a, double power) {
  return {a.high * power, a.low * power};
}

/** 1/k!, k = 0 … 17 */
constexpr DoubleDouble kInverseFactorial[] = {
    {1, 0},
    {1, 0},
    {0.5, 0},
    {0x1.5555555555555p-3, 0x1.5555555555555p-57},
    {0x1.5555555555555p-5, 0x1.5555555555555p-59},
    {0x1.1111111111111p-7, 0x1.1111111111111p-63},
    {0x1.6c16c16c16c17p-10, -0x1.f49f49f49f49fp-65},
    {0x1.a01a01a01a01ap-13, 0x1.a01a01a01a01ap-73},
    {0x1.a01a01a01a01ap-16, 0x1.a01a01a01a01ap-76},
    {0x1.71de3a556c734p-19, -0x1.c154f8ddc6c00p-73},
    {0x1.27e4fb7789f5cp-22, 0x1.cbbc05b4fa99ap-76},
    {0x1.ae64567f544e4p-26, -0x1.c062e06d1f209p-80},
    {0x1.1eed8eff8d898p-29, -0x1.2aec959e14c06p-83},
    {0x1.6124613a86d09p-33, 0x1.f28e0cc748ebep-87},
    {0x1.93974a8c07c9dp-37, 0x1.05d6f8a2efd1fp-92},
    {0x1.ae7f3e733b81fp-41, 0x1.1d8656b0ee8cbp-97},
    {0x1.ae7f3e733b81fp-45, 0x1.1d8656b0ee8cbp-101},
    {0x1.952c77030ad4ap-49, 0x1.ac981465ddc6cp-103},
};

/** Returns eᵃ, relative error a few 2⁻¹⁰⁴ (|a| + 1); 0 below −700. */
inline DoubleDouble exp(const DoubleDouble& a) {
  constexpr DoubleDouble kLn2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
  constexpr int kHalvings = 8, kTerms = 10;
  if (a.high < -700) return 0.0;
  const double n = __builtin_rint(a.high / kLn2.high);
  const DoubleDouble r = scaled(a - kLn2 * n, 1.0 / (1 << kHalvings));  // |r| < 0.0014
  // eʳ − 1 by Taylor, then (1 + x)² − 1 = 2x + x²: nothing cancels.
  DoubleDouble x = kInverseFactorial[kTerms];
  for (int k = kTerms - 1; k > 0; --k) x = x * r + kInverseFactorial[k];
  x = x * r;
  for (int k = 0; k < kHalvings; ++k) x = scaled(x, 2) + x * x;
  return scaled(x + 1.0, __builtin_ldexp(1.0, static_cast<int>(n)));
}

/** Returns ln a for a > 0: one Newton step from the double's. */
inline DoubleDouble log(const DoubleDouble& a) {
  const double guess = __builtin_log(a.high);
  const DoubleDouble e = a * exp(DoubleDouble(-guess)) - 1.0;
  return (e - e * e * 0.5) + guess;
}

/** Returns the angle of the point (x, y), both ≥ 0 and not both 0: one Newton step from the double's. */
inline DoubleDouble atan2(const DoubleDouble& y, const DoubleDouble& x) {
  constexpr int kHalvings = 5;
  const double guess = __builtin_atan2(y.high, x.high);
  // sin of guess/32 by Taylor, then the double angle five times, in s = sin and v = 1 − cos.
  const double r = guess / (1 << kHalvings);  // ≤ 0.05
  const DoubleDouble r2 = exactProduct(r, r);
  DoubleDouble series = kInverseFactorial[17];
  for (int k = 15; k > 0; k -= 2) series = kInverseFactorial[k] - series * r2;
  DoubleDouble s = series * r;
  DoubleDouble v = s * s / (sqrt(1.0 - s * s) + 1.0);
  for (int k = 0; k < kHalvings; ++k) {
    const DoubleDouble square = s * s;
    s = scaled(s - s * v, 2);
    v = scaled(square, 2);
  }
  const DoubleDouble c = 1.0 - v;
  const DoubleDouble turn = (y * c - x * s) / (x * c + y * s);  // tan of the remaining angle, ~1e-16
  return turn + guess;
}

inline double toDouble(const DoubleDouble& a) {
  return a.high + a.low;
}

/** Returns a·2ⁿ. */
inline double toDouble(const DoubleDouble& a, int n) {
  return __builtin_ldexp(toDouble(a), n);
}

inline Pair asPair(const DoubleDouble& a) {
  return {a.high, a.low};
}

/** What the set-up needs to know of its type of number. */
template <class Real>
struct Number;

template <>
struct Number<DoubleDouble> {
  static constexpr int kPrecision = 106;  ///< significant bits
  static DoubleDouble pi() { return {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53}; }
  static DoubleDouble powerOfTwo(int n) { return __builtin_ldexp(1.0, n); }
  /** Returns x·2ⁿ, exactly where that is a double. */
  static DoubleDouble exactly(double x, int n) { return __builtin_ldexp(x, n); }
};

}  // namespace poinsot::closed_form::POINSOT_SIMD_LEVEL
