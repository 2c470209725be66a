#include "claims.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace poinsot::validation {

namespace {

std::string brief(double number) {
  std::ostringstream out;
  out << number;
  std::string text = out.str();
  const std::size_t zero = text.find("e-0");
  return zero == std::string::npos ? text : text.erase(zero + 2, 1);
}

}  // namespace

Claim within(int of, const std::string& figure, const std::string& source, const std::string& value, double tolerance,
             int decimals) {
  const double number = std::stod(value);
  return {figure, source, value, " ± " + brief(tolerance), number - tolerance, number + tolerance, decimals, of};
}

Claim between(int of, const std::string& figure, const std::string& source, const std::string& words, double low,
              double high, int decimals) {
  return {figure, source, words, ": " + brief(low) + " … " + brief(high), low, high, decimals, of};
}

testing::AssertionResult agrees(const Claim& claim, double computed) {
  if (std::isfinite(computed) && computed >= claim.low && computed <= claim.high) return testing::AssertionSuccess();
  return testing::AssertionFailure() << claim.figure << ": " << std::setprecision(15) << computed << " is not in ["
                                     << claim.low << ", " << claim.high << "]; " << claim.source << " says "
                                     << claim.published << claim.allowed;
}

std::string shown(const Claim& claim, double computed) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(claim.decimals) << computed;
  return text.str();
}

}  // namespace poinsot::validation
