// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "tensortopo/scalar/nearest.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo::test {
namespace {

Rational power_of_two(int exponent) { return exactly(std::ldexp(1.0, exponent)); }

Rational distance(const Rational& x, const Rational& y) { return x < y ? y - x : x - y; }

RC_GTEST_PROP(Nearest, NoOtherDoubleIsNearer, (long p, long q)) {
  RC_PRE(q != 0);
  const Rational value = Rational(p) / Rational(q);
  const double x = nearest<double>(value);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double side : {-infinity, infinity})
    RC_ASSERT(distance(exactly(x), value) <= distance(exactly(std::nextafter(x, side)), value));
}

RC_GTEST_PROP(Nearest, NumbersOfTheFormatStayWhatTheyAre, (double x)) {
  RC_PRE(std::isfinite(x));
  RC_ASSERT(nearest<double>(exactly(x)) == x);
  const Real50 third = Real50(x) / 3;
  RC_ASSERT(nearest<Real50>(exactly(third)) == third);
  RC_ASSERT(nearest<Real100>(exactly(third)) == Real100(third));
}

TEST(Nearest, TiesGoToTheEvenNumber) {
  EXPECT_EQ(nearest<double>(1 + power_of_two(-53)), 1.0);
  EXPECT_EQ(nearest<double>(1 + 3 * power_of_two(-53)), 1 + std::ldexp(1.0, -51));
}

// By way of 50 digits this would be a tie.
TEST(Nearest, IsRoundedOnce) {
  const double above = std::nextafter(0.5, 1.0);
  const Rational value = Rational(1) / 2 + power_of_two(-54) + power_of_two(-200);
  EXPECT_EQ(nearest<double>(value), above);
  const auto mode = ModeValue::parse(value.str());
  EXPECT_EQ(mode.approx(), above);
  EXPECT_EQ(mode_parameter<double>(mode).mu, above);
}

}  // namespace
}  // namespace tensortopo::test
