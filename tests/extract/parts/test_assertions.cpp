// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#ifndef TENSORTOPO_ASSERTIONS
#define TENSORTOPO_ASSERTIONS
#endif
#include <gtest/gtest.h>

#include "extract/run/assert.hpp"

namespace tensortopo::test {
namespace {

// Built as sanitizer builds are: an assertion that fails names the condition and ends the program,
// one that holds is evaluated once.
TEST(AssertionsDeathTest, EndTheProgramWithTheCondition) {
  int evaluated = 0;
  TENSORTOPO_ASSERT(++evaluated == 1, "holds");
  EXPECT_EQ(evaluated, 1);
  EXPECT_DEATH(TENSORTOPO_ASSERT(evaluated == 2, "two"), "broken invariant: two .evaluated == 2.");
}

}  // namespace
}  // namespace tensortopo::test
