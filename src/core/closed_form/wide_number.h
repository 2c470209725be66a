#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "double_double.h"

namespace poinsot::closed_form::POINSOT_SIMD_LEVEL {

namespace mp = boost::multiprecision;

constexpr int kBits = 2304;

/**
 * What set_up.h asks of a number, with an exponent of 30 bits and enough digits for any phase: up to 2¹⁰²⁴ s times
 * 2¹⁰²⁴ rad/s, with some 110 bits below a turn.
 */
using Wide = mp::number<mp::cpp_bin_float<kBits, mp::digit_base_2>, mp::et_off>;

inline Wide scaled(const Wide& a, double power) {
  return a * power;
}
template <>
inline Wide powerOfTwo<Wide>(int n) {
  return ldexp(Wide(1), n);
}
inline double toDouble(const Wide& a) {
  return a.convert_to<double>();
}
inline double toDouble(const Wide& a, int n) {
  return ldexp(a, n).convert_to<double>();
}
inline Pair asPair(const Wide& a) {
  const double high = toDouble(a);
  return {high, toDouble(Wide(a - high))};
}
template <>
inline Wide exactly<Wide>(double x, int n) {
  return ldexp(Wide(x), n);
}
template <>
inline Wide pi<Wide>() {
  return boost::math::constants::pi<Wide>();
}
template <>
constexpr int precision<Wide>() {
  return kBits;
}

}  // namespace poinsot::closed_form::POINSOT_SIMD_LEVEL
