#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "double_double.h"

namespace poinsot::closed_form::POINSOT_SIMD_LEVEL {

/** A number for set_up.h, of any number of bits and with an exponent of 30 bits. Does not allocate. */
template <int kBits>
using Wide =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<kBits, boost::multiprecision::digit_base_2>,
                                  boost::multiprecision::et_off>;

template <class Float, boost::multiprecision::expression_template_option kOption>
boost::multiprecision::number<Float, kOption> scaled(const boost::multiprecision::number<Float, kOption>& a,
                                                     double power) {
  return a * power;
}

template <class Float, boost::multiprecision::expression_template_option kOption>
double toDouble(const boost::multiprecision::number<Float, kOption>& a) {
  return a.template convert_to<double>();
}

template <class Float, boost::multiprecision::expression_template_option kOption>
double toDouble(const boost::multiprecision::number<Float, kOption>& a, int n) {
  return toDouble(boost::multiprecision::number<Float, kOption>(ldexp(a, n)));
}

template <class Float, boost::multiprecision::expression_template_option kOption>
Pair asPair(const boost::multiprecision::number<Float, kOption>& a) {
  const double high = toDouble(a);
  return {high, toDouble(boost::multiprecision::number<Float, kOption>(a - high))};
}

template <class Float, boost::multiprecision::expression_template_option kOption>
struct Number<boost::multiprecision::number<Float, kOption>> {
  using Real = boost::multiprecision::number<Float, kOption>;
  static constexpr int kPrecision = std::numeric_limits<Real>::digits;
  static Real pi() { return boost::math::constants::pi<Real>(); }
  static Real powerOfTwo(int n) { return ldexp(Real(1), n); }
  static Real exactly(double x, int n) { return ldexp(Real(x), n); }
};

}  // namespace poinsot::closed_form::POINSOT_SIMD_LEVEL
