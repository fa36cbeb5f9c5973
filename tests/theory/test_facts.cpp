// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tensortopo/theory/facts.hpp"

namespace tensortopo::theory {
namespace {

using Kind = Outcome::Kind;

Rational random_number() {
  const int digits = *rc::gen::inRange(-1000000, 1000000);
  const int denominator = *rc::gen::inRange(1, 5000);
  return Rational(digits) / Rational(denominator);
}

// Whether the enclosure of the exact result of a chain of operations contains it.
template <class Real>
bool contains(const Bounded<Real>& x, const Rational& exact) {
  const auto rational = [](const Real& r) {
    if constexpr (std::is_same_v<Real, double>) {
      return Rational(r);
    } else {
      Rational q;
      mpfr_get_q(q.backend().data(), r.backend().data());
      return q;
    }
  };
  return abs(Rational(rational(x.value) - exact)) <= rational(x.error);
}

template <class Real>
void check_containment() {
  using B = Bounded<Real>;
  const Rational p = random_number(), q = random_number(), r = random_number();
  const B x = enclosing<B>(p), y = enclosing<B>(q), z = enclosing<B>(r);
  RC_ASSERT(contains(x, p));
  RC_ASSERT(contains(x + y * z, p + q * r));
  RC_ASSERT(contains((x - y) * (x + y) - x * x + y * y, Rational(0)));
  if (q != 0 && r != 0) RC_ASSERT(contains(x / y - z / (y * z), p / q - 1 / q));
  if (p != q) {
    const B quotient = z / (x - y);
    if (std::isfinite(static_cast<double>(quotient.error))) {
      RC_ASSERT(contains(quotient, r / (p - q)));
    }
  }
}

RC_GTEST_PROP(Bounded, ContainsTheExactResultInDoubles, ()) { check_containment<double>(); }
RC_GTEST_PROP(Bounded, ContainsTheExactResultAtAHundredDigits, ()) { check_containment<Real100>(); }

TEST(Bounded, KnowsNothingAfterADivisionByWhatMayBeZero) {
  const Bounded53 x = enclosing<Bounded53>(Rational(Rational(1) / 3));
  const Bounded53 quotient = Bounded53(1) / (x + x + x - Bounded53(1));
  EXPECT_TRUE(std::isinf(quotient.error));
  EXPECT_EQ(certified_sign(quotient), Verdict::unknown);
  EXPECT_EQ(certified_sign(x), Verdict::positive);
  EXPECT_EQ(certified_sign(Bounded53(0)), Verdict::zero);
}

RC_GTEST_PROP(Enclosing, ContainsTheNumber, ()) {
  const Rational q = random_number();
  const Interval i = enclosing<Interval>(q);
  RC_ASSERT(Rational(i.inf()) <= q && q <= Rational(i.sup()));
  RC_ASSERT(contains(enclosing<Bounded53>(q), q));
  RC_ASSERT(contains(enclosing<Bounded100>(q), q));
  RC_ASSERT(enclosing<Rational>(q) == q);
}

TEST(Facts, AreAllDecidedByRationals) {
  Facts<Rational> facts;
  facts.equal("a third", Rational(Rational(1) / 3) * 3, Rational(1));
  facts.positive("five", Rational(5));
  EXPECT_EQ(facts.outcome(), Outcome::holds());
  facts.about([] { return "here"; });
  facts.negative("five", Rational(5));
  facts.zero("six", Rational(6));
  EXPECT_EQ(facts.outcome(), Outcome::violated("five: here"));
  EXPECT_TRUE(facts.is_settled());
}

TEST(Facts, OfEqualityStayOpenOverEnclosures) {
  Facts<Interval> facts;
  const Interval third = facts.number(Rational(Rational(1) / 3));
  facts.equal("a third", third * Interval(3), Interval(1));
  const Outcome open = facts.outcome();
  EXPECT_EQ(open.kind, Kind::undecided);
  EXPECT_GT(open.reach, 0);
  EXPECT_LT(open.reach, std::ldexp(1.0, -50));
  facts.equal("a half", third, facts.number(Rational(Rational(1) / 2)));
  EXPECT_EQ(facts.outcome().kind, Kind::violated);
}

TEST(Facts, OfStrictSignsAreCertifiedByEnclosures) {
  Facts<Bounded53> facts;
  const Bounded53 third = facts.number(Rational(Rational(1) / 3));
  facts.positive("a third", third);
  facts.same_sign("a third and its square", third, third * third);
  facts.not_zero("a third", third);
  EXPECT_EQ(facts.outcome(), Outcome::holds());
  facts.not_negative("minus a third", -third);
  EXPECT_EQ(facts.outcome().kind, Kind::violated);
}

TEST(Facts, CountTheNumbersOfAClaimAndChangeOne) {
  Facts<Rational> facts(Mutation{1, -1});
  EXPECT_EQ(facts.claimed(1, 2), Rational(1) / 2);
  EXPECT_EQ(facts.claimed(1, 2), Rational(-1) / 2);
  EXPECT_EQ(facts.claimed_count(4), 4);
  EXPECT_EQ(facts.constants(), 3u);
}

TEST(Arithmetics, AreCalledByTheirNames) {
  for (const Arithmetic arithmetic : kArithmetics) {
    EXPECT_EQ(arithmetic_called(name(arithmetic)), arithmetic);
  }
  EXPECT_EQ(arithmetic_called("float"), std::nullopt);
}

}  // namespace
}  // namespace tensortopo::theory
