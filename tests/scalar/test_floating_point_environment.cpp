// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "tensortopo/scalar/floating_point_environment.hpp"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace tensortopo {
namespace {

TEST(FloatingPointEnvironment, IsSoundInAFreshThread) {
  EXPECT_TRUE(floating_point_environment_is_sound());
}

TEST(FloatingPointEnvironment, DetectsDirectedRoundingRepairsItAndPutsItBack) {
  std::fesetround(FE_UPWARD);
  EXPECT_FALSE(floating_point_environment_is_sound());
  {
    const FloatingPointEnvironment guard;
    EXPECT_TRUE(floating_point_environment_is_sound());
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  }
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  std::fesetround(FE_TONEAREST);
}

TEST(FloatingPointEnvironment, DetectsEveryRoundingDirectionButNearest) {
  for (const int direction : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(direction);
    const bool sound = floating_point_environment_is_sound();
    std::fesetround(FE_TONEAREST);
    EXPECT_FALSE(sound) << direction;
  }
}

#if defined(__SSE2__)
void flushing_state_is_repaired_and_put_back(unsigned bit) {
  const unsigned former = _mm_getcsr();
  _mm_setcsr(former | bit);
  EXPECT_FALSE(floating_point_environment_is_sound());
  {
    const FloatingPointEnvironment guard;
    EXPECT_TRUE(floating_point_environment_is_sound());
    volatile double smallest = std::numeric_limits<double>::denorm_min(), two = 2;
    EXPECT_EQ(smallest * two, 2 * std::numeric_limits<double>::denorm_min());
  }
  EXPECT_EQ(_mm_getcsr() & bit, bit);
  _mm_setcsr(former);
}

TEST(FloatingPointEnvironment, UndoesFlushToZero) {
  flushing_state_is_repaired_and_put_back(0x8000u);
}

TEST(FloatingPointEnvironment, UndoesDenormalsAreZero) {
  flushing_state_is_repaired_and_put_back(0x0040u);
}
#endif

}  // namespace
}  // namespace tensortopo
