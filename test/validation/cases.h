#pragma once

#include <array>
#include <functional>
#include <iosfwd>
#include <limits>
#include <string>
#include <vector>

#include "claims.h"
#include "poinsot/core/motion.h"

namespace poinsot::validation {

/** A figure that a case does not have, or that could not be measured. No claim agrees with it. */
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/** A motion of which numbers were published. */
struct Case {
  std::string name;    ///< also the last part of the test's name
  std::string inputs;  ///< as the source gives them
  MotionSetup setup;   ///< the same in SI

  /** The figures, taken from the states of the motion alone, for any method. */
  std::function<std::vector<double>(const MotionSetup&)> measure{};
  /** The same figures where the closed form gives them without a trajectory, else kNone; may be empty. */
  std::function<std::vector<double>(const ClosedForm&)> say{};

  std::vector<Claim> claims{};

  /** Pairs of moments: after exchange the motion is another, and at least one claim must fail. */
  std::vector<std::array<int, 2>> swaps{{0, 1}, {1, 2}, {0, 2}};

  /** Whether disturbances as small as rounding move the figures out of tolerance, but for methods that keep E and L. */
  bool feels_rounding = false;
};

std::ostream& operator<<(std::ostream& out, const Case& one);

/** Motions without torque. */
const std::vector<Case>& freeCases();

/** Motions under torque. */
const std::vector<Case>& torqueCases();

/** All that doc/validation.md shows, in its order. */
std::vector<Case> allCases();

/** Whether all claims of a case agree; says which do not. */
testing::AssertionResult agrees(const Case& one, const std::vector<double>& figures);

/** The lines of doc/validation.md for a case. Neighbours of one name and source, such as components, share a line. */
std::vector<std::string> rows(const Case& one, const std::vector<double>& figures);

/** The setup with two principal moments exchanged. */
MotionSetup swapped(const MotionSetup& setup, const std::array<int, 2>& pair);

}  // namespace poinsot::validation
