#pragma once

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <sstream>

namespace poinsot {

inline void checkFewCases(void (*property)()) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  rc::detail::TestMetadata metadata;
  metadata.id = std::string(test->test_suite_name()) + "/" + test->name();
  metadata.description = test->name();
  rc::detail::TestParams few = rc::detail::configuration().testParams;
  few.maxSuccess = std::max(1, few.maxSuccess / 40);
  const rc::detail::TestResult result = rc::detail::checkTestable(property, metadata, few);
  if (result.is<rc::detail::SuccessResult>()) return;
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  FAIL() << text.str();
}

}  // namespace poinsot

/** As RC_GTEST_PROP, with a fortieth of the cases: for properties that take milliseconds each. */
#define SLOW_PROPERTY(Suite, Name)                        \
  void slowProperty##Suite##Name();                       \
  TEST(Suite, Name) {                                     \
    ::poinsot::checkFewCases(&slowProperty##Suite##Name); \
  }                                                       \
  void slowProperty##Suite##Name()
