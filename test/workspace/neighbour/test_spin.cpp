#include <gtest/gtest.h>

#include <cmath>

#include "spin.h"

TEST(Spin, turnsBackwardsToo) {
  const poinsot::BodyState state = spinOfTop(-2);
  EXPECT_NEAR(state.attitude.w, std::cos(0.5), 1e-9);
  EXPECT_NEAR(state.attitude.z, -std::sin(0.5), 1e-9);
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
