#pragma once

#include <gtest/gtest.h>

#include <string>

namespace poinsot::validation {

/** One published number, its source, and the interval in which a computed one agrees with it. */
struct Claim {
  std::string figure;     ///< what was measured, with its unit
  std::string source;     ///< who published it; "[M]" where it was recomputed from the published inputs
  std::string published;  ///< as it stands there
  std::string allowed;    ///< low and high, for the reader
  double low, high;       ///< allowed, ends included
  int decimals;           ///< with which the computed value is shown
  int of;                 ///< which of the case's figures, from 0
};

/**
 * A number that must be met to ± `tolerance`.
 * @param value as it stands in the source; read and shown from this one text.
 */
Claim within(int of, const std::string& figure, const std::string& source, const std::string& value, double tolerance,
             int decimals);

/** A number that must lie in [low, high], where the source gives an interval, or words. */
Claim between(int of, const std::string& figure, const std::string& source, const std::string& words, double low,
              double high, int decimals);

/** Fails for NaN and infinity too. */
testing::AssertionResult agrees(const Claim& claim, double computed);

/** `computed` as the document shows it. */
std::string shown(const Claim& claim, double computed);

}  // namespace poinsot::validation
