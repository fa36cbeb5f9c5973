// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tensortopo/scalar/constants.hpp"
#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {
namespace {

static_assert(RealScalar<double> && RealScalar<Real50> && RealScalar<Real100>);
static_assert(OrderedField<Rational> && !RealScalar<Rational>, "rationals have no roots");
static_assert(FieldScalar<Interval> && !OrderedField<Interval>, "overlapping sets have no order");
static_assert(RingScalar<Rational> && RingScalar<Interval> && RingScalar<double>);

template <class T>
concept CanAskPi = requires {
  pi<T>();
};
static_assert(CanAskPi<double> && !CanAskPi<Rational> && !CanAskPi<Interval>);

static_assert(-Sign::positive == Sign::negative && -Sign::zero == Sign::zero);
static_assert(Sign::negative * Sign::negative == Sign::positive);
static_assert(Sign::negative * Sign::zero == Sign::zero);
static_assert(!std::is_convertible_v<Verdict, int> && !std::is_convertible_v<Verdict, Sign>);

TEST(Scalar, RationalHoldsEveryDoubleExactly) {
  EXPECT_TRUE(Rational(0.1) != Rational(1) / Rational(10));
  EXPECT_TRUE(Rational(0.1) * Rational(36028797018963968.0) == Rational(3602879701896397.0));
}

TEST(Scalar, SignOfOrderedScalars) {
  EXPECT_EQ(sign_of(Rational(-1) / Rational(3)), Sign::negative);
  EXPECT_EQ(sign_of(0.0), Sign::zero);
  EXPECT_EQ(sign_of(Real50("1e-400")), Sign::positive);
}

TEST(Scalar, PiHasTheDigitsOfTheScalar) {
  const Real50 expected("3.14159265358979323846264338327950288419716939937510582097494459");
  EXPECT_TRUE(abs(pi<Real50>() - expected) < Real50("1e-49"));
}

}  // namespace
}  // namespace tensortopo
