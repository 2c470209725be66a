#include "number.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>

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
  std::string word = text.substr(scan.at);
  for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return word == "nan" || word == "inf" || word == "infinity";
}

/** The value of a decimal number; infinite beyond the largest double. */
double valueOf(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = 0;
  in >> value;
  return in.fail() ? HUGE_VAL : value;  // the grammar holds, so only overflow can fail
}

std::string allowedKind(const Quantity& quantity) {
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

}  // namespace

std::string allowedNumber(const Quantity& quantity) {
  return "a " + allowedKind(quantity) + " number" + unitOf(quantity);
}

std::string allowedNumbers(std::size_t count, const Quantity& quantity) {
  return "a list of " + std::to_string(count) + " " + allowedKind(quantity) + " numbers" + unitOf(quantity);
}

double readNumber(const Place& place, const Quantity& quantity) {
  const auto refuse = [&](const std::string& why) { place.refuse(place.found() + why, allowedNumber(quantity)); };
  if (!place.node().IsScalar()) refuse(" is not a number");
  const std::string& text = place.node().Scalar();
  if (namesNonFinite(text)) refuse(" is not finite");
  const Notation notation = notationOf(text);
  if (notation == Notation::leading_zero) refuse(" has a leading zero, which some readers take as octal");
  if (notation == Notation::none) refuse(" is not a decimal number");
  const double value = valueOf(text);
  if (!std::isfinite(value)) refuse(" is not finite in double precision");
  if (quantity.range == Quantity::Range::positive && !(value > 0)) refuse(" is not positive");
  if (quantity.range == Quantity::Range::not_negative && value < 0) refuse(" is negative");
  return value;
}

std::vector<double> readNumbers(const Place& place, std::size_t count, const Quantity& quantity) {
  const std::string allowed = allowedNumbers(count, quantity);
  place.requireList(allowed);
  const std::size_t size = place.node().size();
  if (size != count) place.refuse(place.found() + (size < count ? " is too short" : " is too long"), allowed);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(readNumber(place.item(i), quantity));
  return numbers;
}

Eigen::Vector3d readVector(const Place& place, const Quantity& quantity) {
  return Eigen::Vector3d(readNumbers(place, 3, quantity).data());
}

Eigen::Quaterniond readRotation(const Place& place) {
  const std::vector<double> wxyz = readNumbers(place, 4, quantity::kQuaternionEntry);
  double largest = 0;
  for (const double entry : wxyz) largest = std::max(largest, std::abs(entry));
  if (largest == 0) place.refuse("a zero quaternion is no rotation", "four finite numbers w x y z, not all zero");
  // A power of two first, so that no square leaves the range of doubles and nothing is rounded.
  const int exponent = std::ilogb(largest);
  const auto scaled = [&](int i) { return std::scalbn(wxyz[i], -exponent); };
  return Eigen::Quaterniond(scaled(0), scaled(1), scaled(2), scaled(3)).normalized();
}

}  // namespace poinsot::scene
