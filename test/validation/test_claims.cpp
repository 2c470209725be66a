// The judge can fail.
#include <gtest/gtest.h>

#include <limits>

#include "claims.h"

namespace poinsot::validation {
namespace {

TEST(Claims, areHeldToTheirTolerance) {
  const Claim claim = within(0, "period [s]", "someone", "12.5", 0.25, 3);
  for (const double good : {12.25, 12.5, 12.75}) EXPECT_TRUE(agrees(claim, good));
  for (const double bad : {12.249, 12.751, -12.5, 0.0, 12.5 * 60, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(agrees(claim, bad)) << bad;
  }
}

TEST(Claims, ofAnIntervalAreHeldToItsEnds) {
  const Claim claim = between(0, "twist [°]", "someone", "about half a turn", 160, 200, 1);
  EXPECT_TRUE(agrees(claim, 160));
  EXPECT_TRUE(agrees(claim, 200));
  EXPECT_FALSE(agrees(claim, 159.9));
  EXPECT_FALSE(agrees(claim, 200.1));
}

TEST(Claims, sayWhatIsWrongAndWhoSaidIt) {
  const auto answer = agrees(within(0, "period [s]", "someone", "12.5", 0.25, 3), 13);
  EXPECT_STREQ(answer.message(), "period [s]: 13 is not in [12.25, 12.75]; someone says 12.5 ± 0.25");
}

TEST(Claims, areShownWithTheirDecimals) {
  EXPECT_EQ(shown(within(0, "", "", "-1.5", 1, 3), -1.23456), "-1.235");
}

}  // namespace
}  // namespace poinsot::validation
