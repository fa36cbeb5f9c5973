// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The format in software that other machines compute with, against the processor's own.
#include "tensortopo/scalar/software_extended.hpp"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <random>

namespace {

using Extended = tensortopo::SoftwareExtended;

#if LDBL_MANT_DIG == 64
/// Exact: both have 64 bits.
long double native(const Extended& x) { return static_cast<long double>(x); }

TEST(ExtendedInSoftware, ComputesAsTheProcessor) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::size_t compared = 0;
  const auto operand = [&] {
    // 64 bits, of sizes that make sums cancel and products small.
    const long double high = unit(random), low = unit(random);
    return std::ldexp(high + low * 0x1p-52L, static_cast<int>(random() % 200) - 100);
  };
  for (int i = 0; i < 20000; ++i) {
    const long double a = operand(), b = i % 3 == 0 ? a * (1 + 0x1p-40L * operand()) : operand();
    const Extended x(a), y(b);
    ASSERT_EQ(native(x), a);
    ASSERT_EQ(native(Extended(x + y)), a + b) << static_cast<double>(a);
    ASSERT_EQ(native(Extended(x - y)), a - b) << static_cast<double>(a);
    ASSERT_EQ(native(Extended(x * y)), a * b) << static_cast<double>(a);
    ASSERT_EQ(native(Extended(x / y)), a / b) << static_cast<double>(a);
    ASSERT_EQ(native(Extended(sqrt(abs(x)))), std::sqrt(std::abs(a))) << static_cast<double>(a);
    ASSERT_EQ(static_cast<double>(x), static_cast<double>(a));
    ASSERT_EQ(ilogb(x), std::ilogb(a));
    compared += 8;
  }
  EXPECT_EQ(compared, 160000U);
}

TEST(ExtendedInSoftware, IsRoundedToDoubleAsByTheProcessor) {
  // Halfway between doubles, beside that, and where doubles are subnormal.
  std::mt19937_64 random(2);
  for (int i = 0; i < 20000; ++i) {
    const long double mantissa = static_cast<long double>((random() >> 11U) | (1ULL << 52U));
    const long double rest[] = {0.5L, 0.5L - 0x1p-11L, 0.5L + 0x1p-11L, 0.0L};
    const int exponent = i % 2 == 0 ? -52 : -1125 + static_cast<int>(random() % 60);
    const long double value = std::ldexp(mantissa + rest[i % 4], exponent);
    ASSERT_EQ(static_cast<double>(Extended(value)), static_cast<double>(value)) << i;
  }
}
#endif

TEST(ExtendedInSoftware, HasTheSameBitsEverywhere) {
  const Extended third = Extended(1) / 3;
  EXPECT_EQ(static_cast<double>(Extended(third * 0x1p64 - Extended(0x1.5555555555555p62))), 341.5);
}

}  // namespace
