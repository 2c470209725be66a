#include <gtest/gtest.h>

#include "poinsot/ros/requests_text.h"

using poinsot::node::joined;
using poinsot::node::withAll;

namespace {

TEST(RequestsText, namesEachRequestOnce) {
  EXPECT_EQ(joined({}), "");
  EXPECT_EQ(joined({"reset"}), "reset");
  EXPECT_EQ(joined(withAll({"spin of a"}, {"reset"})), "spin of a and reset");
  EXPECT_EQ(joined(withAll({"spin of a", "reset"}, {"spin of a"})), "spin of a and reset");
}

TEST(RequestsText, aNameThatBeginsAnotherIsNamedToo) {
  EXPECT_EQ(joined(withAll({"spin of wing2"}, {"spin of wing"})), "spin of wing2 and spin of wing");
}

}  // namespace
