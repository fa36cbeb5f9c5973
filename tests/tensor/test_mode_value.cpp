// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {
namespace {

TEST(ModeValue, ReadsDecimalsFractionsAndExponentsExactly) {
  EXPECT_EQ(ModeValue::parse("0.5").text(), "1/2");
  EXPECT_EQ(ModeValue::parse("-9/10").text(), "-9/10");
  EXPECT_EQ(ModeValue::parse("1e-6").text(), "1/1000000");
  EXPECT_EQ(ModeValue::parse("143/343").text(), "143/343");
  EXPECT_EQ(ModeValue::parse("+.25E0").text(), "1/4");
  EXPECT_EQ(ModeValue::parse("-12.50e-2").text(), "-1/8");
  EXPECT_EQ(ModeValue::parse("0.001e3").text(), "1");
  EXPECT_EQ(ModeValue::parse("1.").text(), "1");
  EXPECT_EQ(ModeValue::parse("-0.0").text(), "0");
  EXPECT_EQ(ModeValue::parse("-0/7").text(), "0");
}

TEST(ModeValue, LeadingZerosAreDecimal) {
  EXPECT_EQ(ModeValue::parse("010/0100").text(), "1/10");
  EXPECT_EQ(ModeValue::parse("00.08").text(), "2/25");
  EXPECT_EQ(ModeValue::parse("1e-08").text(), "1/100000000");
}

TEST(ModeValue, WritesLowestTerms) {
  EXPECT_EQ(ModeValue::parse("286/686"), ModeValue::parse("143/343"));
  EXPECT_EQ(ModeValue::parse("0.50"), ModeValue::parse("1/2"));
  EXPECT_EQ(ModeValue::parse("343/343").text(), "1");
}

TEST(ModeValue, RefusesWhatIsNotAMode) {
  for (const char* text : {"",
                           "-",
                           "+",
                           ".",
                           "abc",
                           "1e",
                           "1e+",
                           "1/",
                           "/2",
                           "1/0",
                           "0/0",
                           "1//2",
                           "1/-2",
                           "0.5/2",
                           "1/2.0",
                           "1/2e1",
                           "0x1",
                           "1 ",
                           " 1",
                           "0,5",
                           "--1",
                           "+-1",
                           "nan",
                           "inf",
                           "1.5",
                           "-1.0001",
                           "3/2",
                           "1e1",
                           "1e999999999999",
                           "1e-301",
                           "0.5 # half",
                           "1\n",
                           "1e-300e1",
                           "0.1.2"})
    EXPECT_THROW(ModeValue::parse(text), std::invalid_argument) << text;
  EXPECT_THROW(ModeValue::parse("0." + std::string(400, '1')), std::invalid_argument);
  EXPECT_THROW(ModeValue::parse("0." + std::string(250, '0') + "1e-100"), std::invalid_argument);
  EXPECT_THROW(ModeValue::parse(std::string_view("1\0", 2)), std::invalid_argument);
}

TEST(ModeValue, SaysWhyItRefuses) {
  try {
    ModeValue::parse("3/2");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "mode value \"3/2\": outside [-1, 1]");
  }
}

TEST(ModeValue, OppositeAndSign) {
  EXPECT_EQ(ModeValue::parse("0.9").opposite(), ModeValue::parse("-9/10"));
  EXPECT_EQ(ModeValue::parse("-0.9").opposite(), ModeValue::parse("9/10"));
  EXPECT_EQ(ModeValue().opposite(), ModeValue());
  EXPECT_EQ(ModeValue::parse("-1e-9").sign(), -1);
  EXPECT_EQ(ModeValue().sign(), 0);
  EXPECT_EQ(ModeValue::parse("1").sign(), 1);
}

RC_GTEST_PROP(ModeValue, RoundTripsThroughItsText, ()) {
  const auto denominator = *rc::gen::inRange<long>(1, 1000000);
  const auto numerator = *rc::gen::inRange<long>(-denominator, denominator + 1);
  const std::string text = std::to_string(numerator) + "/" + std::to_string(denominator);
  const ModeValue value = ModeValue::parse(text);
  RC_ASSERT(ModeValue::parse(value.text()) == value);
  RC_ASSERT(to_scalar<Rational>(value) == Rational(numerator) / Rational(denominator));
}

RC_GTEST_PROP(ModeValue, DoubleIsTheNearestAndIntervalTheTightest, ()) {
  const auto denominator = *rc::gen::inRange<long>(1, 1000000000);
  const auto numerator = *rc::gen::inRange<long>(0, denominator + 1);
  const ModeValue value =
      ModeValue::parse(std::to_string(numerator) + "/" + std::to_string(denominator));
  const Rational exact = to_scalar<Rational>(value);
  // Both integers are doubles, and division of doubles rounds to nearest.
  RC_ASSERT(value.approx() == static_cast<double>(numerator) / static_cast<double>(denominator));
  RC_ASSERT(to_scalar<double>(value) == value.approx());
  const Interval set = to_scalar<Interval>(value);
  RC_ASSERT(Rational(set.inf()) <= exact && exact <= Rational(set.sup()));
  RC_ASSERT(set.sup() == set.inf() || set.sup() == std::nextafter(set.inf(), 2.0));
  RC_ASSERT((set.inf() == set.sup()) == (Rational(value.approx()) == exact));
}

TEST(ModeValue, FiftyDigitsAreNotADoubleInDisguise) {
  const Real50 tenth = to_scalar<Real50>(ModeValue::parse("0.1"));
  EXPECT_EQ(tenth, Real50("0.1"));
  EXPECT_NE(tenth, Real50(0.1));
}

}  // namespace
}  // namespace tensortopo
