// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {
namespace {

bool contains(const Interval& set, const Rational& value) {
  return Rational(set.inf()) <= value && value <= Rational(set.sup());
}

/// Doubles of very different sizes with all digits in use.
rc::Gen<double> spread_double() {
  return rc::gen::map(rc::gen::pair(rc::gen::arbitrary<std::int64_t>(), rc::gen::inRange(-40, 40)),
                      [](const std::pair<std::int64_t, int>& p) {
                        return std::ldexp(static_cast<double>(p.first), p.second - 60);
                      });
}

RC_GTEST_PROP(Interval, EachOperationContainsTheExactResult, ()) {
  const double x = *spread_double(), y = *spread_double();
  const Interval ix(x), iy(y);
  const Rational rx(x), ry(y);
  RC_ASSERT(contains(ix + iy, rx + ry));
  RC_ASSERT(contains(ix - iy, rx - ry));
  RC_ASSERT(contains(ix * iy, rx * ry));
  RC_PRE(y != 0);
  RC_ASSERT(contains(ix / iy, rx / ry));
}

RC_GTEST_PROP(Interval, TensorFormsContainTheExactResult, ()) {
  double c[5];
  for (double& x : c) x = *spread_double();
  const Deviator<Interval> di = {c[0], c[1], c[2], c[3], c[4]};
  const Deviator<Rational> dr = {Rational(c[0]), Rational(c[1]), Rational(c[2]), Rational(c[3]),
                                 Rational(c[4])};
  RC_ASSERT(contains(determinant_form(di), determinant_form(dr)));
  RC_ASSERT(contains(norm_form(di), norm_form(dr)));
}

TEST(Interval, AThirdIsNotAPoint) {
  const Interval third = Interval(1) / Interval(3);
  EXPECT_LT(third.inf(), third.sup());
  EXPECT_TRUE(contains(third, Rational(1) / Rational(3)));
}

TEST(Interval, CertifiedSignSaysUnknownWhenSignsDiffer) {
  EXPECT_EQ(certified_sign(Interval(1, 2)), Verdict::positive);
  EXPECT_EQ(certified_sign(Interval(-2, -1)), Verdict::negative);
  EXPECT_EQ(certified_sign(Interval(0, 0)), Verdict::zero);
  EXPECT_EQ(certified_sign(Interval(-1, 1)), Verdict::unknown);
  EXPECT_EQ(certified_sign(Interval(0, 1)), Verdict::unknown);
  EXPECT_EQ(certified_sign(Interval(-1, 0)), Verdict::unknown);
}

TEST(Interval, CertifiedSignOfNotANumberIsUnknown) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(certified_sign(Interval(infinity) - Interval(infinity)), Verdict::unknown);
}

TEST(Interval, SquareOfATinyNumberIsNotACertifiedZero) {
  const Interval tiny(1e-200);
  EXPECT_EQ(certified_sign(Interval(0, (tiny * tiny).sup())), Verdict::unknown);
}

}  // namespace
}  // namespace tensortopo
