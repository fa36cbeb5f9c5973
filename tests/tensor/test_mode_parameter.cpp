// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {
namespace {

struct ExactPair {
  int s_numerator, s_denominator;
  const char* mode;
};
/// Rational solutions of mu = s (9 - s^2) / (3 + s^2)^(3/2).
const ExactPair exact_pairs[] = {{1, 4, "143/343"},
                                 {11, 24, "55693/79507"},
                                 {23, 40, "319033/389017"},
                                 {11, 80, "632269/2685619"},
                                 {1, 15, "253/2197"},
                                 {0, 1, "0"},
                                 {1, 1, "1"}};

template <class Scalar>
class ModeParameterTest : public testing::Test {
 protected:
  static Scalar ulps(int count) { return Scalar(count) * std::numeric_limits<Scalar>::epsilon(); }
};
using Reals = testing::Types<double, Real50, Real100>;
TYPED_TEST_SUITE(ModeParameterTest, Reals);

TEST(ModeParameter, SquareOfTheModeIsExactForRationalS) {
  for (const auto& pair : exact_pairs) {
    const Rational s = Rational(pair.s_numerator) / Rational(pair.s_denominator);
    const Rational mu = to_scalar<Rational>(ModeValue::parse(pair.mode));
    EXPECT_EQ(mode_squared_from_s2<Rational>(s * s), mu * mu) << pair.mode;
  }
}

TYPED_TEST(ModeParameterTest, FindsTheRationalSOfExactPairs) {
  using Scalar = TypeParam;
  for (const auto& pair : exact_pairs) {
    const auto m = mode_parameter<Scalar>(ModeValue::parse(pair.mode));
    const Scalar s = Scalar(pair.s_numerator) / Scalar(pair.s_denominator);
    EXPECT_LE(abs(Scalar(m.s - s)), this->ulps(4) * s) << pair.mode;
    EXPECT_LE(abs(Scalar(m.one_minus_s - (Scalar(1) - s))), this->ulps(8) * (Scalar(1) - s));
    EXPECT_LE(abs(Scalar(m.cos_theta_squared - (Scalar(1) - s * s))),
              this->ulps(8) * (Scalar(1) - s * s));
  }
}

TYPED_TEST(ModeParameterTest, EigenvaluesAreThoseOfAUnitTracelessTensorOfThatMode) {
  using Scalar = TypeParam;
  for (const char* text : {"0", "1e-9", "0.1", "0.5", "-0.5", "0.9", "-0.9998", "1", "-1"}) {
    const auto m = mode_parameter<Scalar>(ModeValue::parse(text));
    const auto& [l1, l2, l3] = m.eigenvalues;
    EXPECT_GE(l1, l2);
    EXPECT_GE(l2, l3);
    EXPECT_LE(abs(Scalar(l1 + l2 + l3)), this->ulps(4)) << text;
    EXPECT_LE(abs(Scalar(l1 * l1 + l2 * l2 + l3 * l3 - Scalar(1))), this->ulps(8)) << text;
    const Scalar mode = Scalar(3) * sqrt(Scalar(6)) * l1 * l2 * l3;
    EXPECT_LE(abs(Scalar(mode - m.abs_mu)), this->ulps(16) * m.abs_mu) << text;
  }
}

TYPED_TEST(ModeParameterTest, IsRelativelyAccurateNextToZeroAndOne) {
  using Scalar = TypeParam;
  for (const char* text : {"1e-12", "1e-100", "0.999999999999", "0.999999999999999",
                           "999999999999999999999/1000000000000000000000"}) {
    const auto m = mode_parameter<Scalar>(ModeValue::parse(text));
    const auto reference = mode_parameter<Real100>(ModeValue::parse(text));
    const auto close = [&](const Scalar& x, const Real100& exact) {
      return abs(Real100(x) - exact) <= Real100(this->ulps(8)) * abs(exact);
    };
    EXPECT_TRUE(close(m.s, reference.s)) << text;
    EXPECT_TRUE(close(m.one_minus_s, Real100(1) - reference.s) ||
                (std::is_same_v<Scalar, Real100> &&
                 abs(Real100(m.one_minus_s) - (Real100(1) - reference.s)) < Real100("1e-99")))
        << text;
    EXPECT_TRUE(close(m.cos_theta_squared, reference.cos_theta_squared)) << text;
    EXPECT_TRUE(close(m.theta, reference.theta)) << text;
    EXPECT_TRUE(close(m.mu_squared, reference.mu_squared)) << text;
  }
}

TYPED_TEST(ModeParameterTest, HundredDigitsAgreeWithTheArcsineOfThePaper) {
  using Scalar = TypeParam;
  for (const char* text : {"0.1", "0.5", "0.9"}) {
    const auto m = mode_parameter<Scalar>(ModeValue::parse(text));
    const Scalar s = sqrt(Scalar(3)) * tan(Scalar(asin(m.abs_mu) / Scalar(3)));
    EXPECT_LE(abs(Scalar(m.s - s)), this->ulps(8)) << text;
    EXPECT_LE(abs(Scalar(sin(m.theta) - m.s)), this->ulps(4)) << text;
  }
}

TEST(ModeParameter, CarriesTheSign) {
  const auto m = mode_parameter<double>(ModeValue::parse("-0.5"));
  EXPECT_EQ(m.sign, -1);
  EXPECT_EQ(m.mu, -0.5);
  EXPECT_EQ(m.abs_mu, 0.5);
  EXPECT_EQ(m.s, mode_parameter<double>(ModeValue::parse("0.5")).s);
}

TEST(ModeParameter, EndsAreExact) {
  const auto zero = mode_parameter<double>(ModeValue());
  EXPECT_EQ(zero.s, 0);
  EXPECT_EQ(zero.eigenvalues[1], 0);
  EXPECT_EQ(zero.cos_theta_squared, 1);
  const auto one = mode_parameter<double>(ModeValue::parse("1"));
  EXPECT_EQ(one.one_minus_s, 0);
  EXPECT_EQ(one.cos_theta_squared, 0);
}

}  // namespace
}  // namespace tensortopo
