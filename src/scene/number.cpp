#include "number.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "characters.h"

namespace poinsot::scene {
namespace {

/** Reads along a text, piece by piece. */
struct Scanner {
  const std::string& text;
  std::size_t at = 0;

  bool skip(const char* any) {
    if (at == text.size() || std::string(any).find(text[at]) == std::string::npos) return false;
    ++at;
    return true;
  }
  std::size_t skipDigits() {
    const std::size_t start = at;
    while (at < text.size() && isDigit(text[at])) ++at;
    return at - start;
  }
  bool atEnd() const { return at == text.size(); }
};

enum class Notation { decimal, leading_zero, none };

Notation notationOf(const std::string& text) {
  Scanner scan{text};
  scan.skip("+-");
  const std::size_t first = scan.at;
  const std::size_t whole_digits = scan.skipDigits();
  if (whole_digits > 1 && scan.atEnd() && text[first] == '0') return Notation::leading_zero;
  const std::size_t fraction_digits = scan.skip(".") ? scan.skipDigits() : 0;
  if (whole_digits + fraction_digits == 0) return Notation::none;
  if (scan.skip("eE")) {
    scan.skip("+-");
    if (scan.skipDigits() == 0) return Notation::none;
  }
  return scan.atEnd() ? Notation::decimal : Notation::none;
}

/** nan, .nan, inf, -.INF, Infinity and the like. */
bool namesNonFinite(const std::string& text) {
  Scanner scan{text};
  scan.skip("+-");
  scan.skip(".");
  const std::string word = lower(text.substr(scan.at));
  return word == "nan" || word == "inf" || word == "infinity";
}

/** Returns the value of a decimal number; infinite beyond the largest double. */
double valueOf(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = 0;
  in >> value;
  return in.fail() ? HUGE_VAL : value;  // the grammar holds, so only overflow can fail
}

std::string kindOf(const Quantity& quantity) {
  switch (quantity.range) {
    case Quantity::Range::positive:
      return "positive finite";
    case Quantity::Range::not_negative:
      return "finite, not negative";
    case Quantity::Range::any:
      return "finite";
  }
  throw std::logic_error("unknown range of numbers");
}

std::string unitOf(const Quantity& quantity) {
  const std::string unit = quantity.unit;
  return unit.empty() ? "" : " (" + unit + ")";
}

std::vector<double> readNumbers(const Place& place, std::size_t count, const Quantity& quantity) {
  place.requireList(expectedNumbers(count, quantity), count, count);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(readNumber(place.item(i), quantity));
  return numbers;
}

}  // namespace

std::string expectedNumber(const Quantity& quantity) {
  return "a " + kindOf(quantity) + " number" + unitOf(quantity);
}

std::string expectedNumbers(std::size_t count, const Quantity& quantity) {
  return "a list of " + std::to_string(count) + " " + kindOf(quantity) + " numbers" + unitOf(quantity);
}

std::string listed(const Eigen::Vector3d& v) {
  return numberText(v[0], 15) + ", " + numberText(v[1], 15) + ", " + numberText(v[2], 15);
}

double readNumber(const Place& place, const Quantity& quantity) {
  const auto refuse = [&](const std::string& why = "") { place.refuse(expectedNumber(quantity), place.found(), why); };
  const std::string& text = place.scalar();
  if (!place.node().IsScalar() || namesNonFinite(text)) refuse();
  const Notation notation = notationOf(text);
  if (notation == Notation::leading_zero) refuse("some readers take the leading zero as octal");
  if (notation == Notation::none) refuse("not a decimal number");
  const double value = valueOf(text);
  if (!std::isfinite(value)) refuse("not finite in double precision");
  if (quantity.range == Quantity::Range::positive && !(value > 0)) {
    const bool underflow = value == 0 && text.find_first_of("123456789") < text.find_first_of("eE");
    refuse(underflow ? "zero in double precision" : "");
  }
  if (quantity.range == Quantity::Range::not_negative && value < 0) refuse();
  return value;
}

Eigen::Vector3d readVector(const Place& place, const Quantity& quantity) {
  return Eigen::Vector3d(readNumbers(place, 3, quantity).data());
}

Eigen::Quaterniond readRotation(const Place& place) {
  const std::vector<double> wxyz = readNumbers(place, 4, quantity::kQuaternionEntry);
  double largest = 0;
  for (const double entry : wxyz) largest = std::max(largest, std::abs(entry));
  if (largest == 0) place.refuse("four finite numbers w x y z, not all zero", "a zero quaternion");
  // A power of two first, so that no square leaves the range of doubles and nothing is rounded.
  const int exponent = std::ilogb(largest);
  const auto scaled = [&](int i) { return std::scalbn(wxyz[i], -exponent); };
  return Eigen::Quaterniond(scaled(0), scaled(1), scaled(2), scaled(3)).normalized();
}

double requireNumber(const Fields& fields, const char* key, const Quantity& quantity) {
  return readNumber(fields.require(key, expectedNumber(quantity)), quantity);
}

Eigen::Vector3d requireVector(const Fields& fields, const char* key, const Quantity& quantity) {
  return readVector(fields.require(key, expectedNumbers(3, quantity)), quantity);
}

}  // namespace poinsot::scene
